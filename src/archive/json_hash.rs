//! JSON files that contain their own hash.

use std::fmt::Write;

use ring::digest::{SHA256, digest};

/// Text before a file's own hash.
const HASH_KEY: &str = "\"sha256\":\"";

/// SHA-256 in hexadecimal digits.
pub fn sha256(content: &[u8]) -> String {
    let mut text = String::new();
    for byte in digest(&SHA256, content).as_ref() {
        // Writing to a String does not fail.
        let _ = write!(text, "{byte:02x}");
    }
    text
}

/// The hash that a JSON file states and the hash of its content. The latter is the SHA-256 of the
/// text without white space and with the first "sha256" value empty. `None` if the file states no
/// hash.
pub fn stated_and_true_hash(json: &str) -> Option<[String; 2]> {
    let mut text = without_white_space(json);
    let from = text.find(HASH_KEY)? + HASH_KEY.len();
    let to = from + text[from..].find('"')?;
    let stated = text[from..to].to_owned();
    text.replace_range(from..to, "");
    Some([stated, sha256(text.as_bytes())])
}

/// JSON without the white space between its tokens.
fn without_white_space(json: &str) -> String {
    let (mut inside, mut escaped) = (false, false);
    json.chars()
        .filter(|&c| {
            let kept = inside || !c.is_ascii_whitespace();
            inside ^= c == '"' && !escaped;
            escaped = inside && c == '\\' && !escaped;
            kept
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use serde_json::json;

    use super::*;

    #[test]
    fn a_changed_number_shows_and_white_space_does_not() {
        let content = r#"{"format":"a b","sha256":"","a":[1.5,2.0],"b":{"sha256":"other"}}"#;
        let hash = sha256(content.as_bytes());
        let file = content.replacen("\"\"", &format!("\"{hash}\""), 1).replace(",\"", ",\n  \"");
        let [stated, found] = stated_and_true_hash(&file).unwrap();
        assert_eq!((&stated, &found), (&hash, &hash));
        let [stated, found] = stated_and_true_hash(&file.replace("1.5", "1.6")).unwrap();
        assert_ne!(stated, found);
        assert_eq!(stated_and_true_hash("{}"), None);
    }

    proptest! {
        #[test]
        fn white_space_between_tokens_does_not_count(
            text in "[ \\\\\"a-c\n]{0,20}", number in -1e6..1e6f64
        ) {
            let content = json!([text, { "key of \\ ": number }, [null, true]]);
            let pretty = serde_json::to_string_pretty(&content).unwrap();
            prop_assert_eq!(without_white_space(&pretty), content.to_string());
        }
    }
}
