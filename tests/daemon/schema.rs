//! Compares JSON with a schema of the OpenAPI document: types, members, enumerations. Stricter than
//! JSON Schema: a member that is not in the schema is an error.

use serde_json::{Map, Value};

/// All differences with their paths; empty if there are none.
pub fn differences(document: &Value, schema: &Value, value: &Value, at: &str) -> Vec<String> {
    let schema = resolved(document, schema);
    for key in ["oneOf", "anyOf"] {
        if let Some(choices) = schema[key].as_array() {
            let tried = choices.iter().map(|choice| differences(document, choice, value, at));
            return tried.min_by_key(Vec::len).unwrap();
        }
    }
    if !is_of_type(&schema["type"], value) {
        return vec![format!("{at}: {value} is not {}", schema["type"])];
    }
    if let Some(words) = schema["enum"].as_array()
        && !words.contains(value)
    {
        return vec![format!("{at}: {value} is none of {words:?}")];
    }
    match value {
        Value::Object(object) => members(document, schema, object, at),
        Value::Array(items) => {
            let item =
                |(n, item)| differences(document, &schema["items"], item, &format!("{at}[{n}]"));
            items.iter().enumerate().flat_map(item).collect()
        }
        _ => Vec::new(),
    }
}

fn resolved<'a>(document: &'a Value, schema: &'a Value) -> &'a Value {
    match schema["$ref"].as_str() {
        Some(place) => {
            let pointer = place.strip_prefix('#').unwrap();
            document.pointer(pointer).unwrap_or_else(|| panic!("{place} is not in the document"))
        }
        None => schema,
    }
}

fn is_of_type(types: &Value, value: &Value) -> bool {
    let is = |name: &Value| match name.as_str().unwrap() {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "integer" => value.is_u64() || value.is_i64(),
        "number" => value.is_number(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        other => panic!("type {other}"),
    };
    match types {
        Value::Null => true,
        Value::Array(names) => names.iter().any(is),
        name => is(name),
    }
}

fn members(document: &Value, schema: &Value, object: &Map<String, Value>, at: &str) -> Vec<String> {
    let (mut known, mut required) = (Map::new(), Vec::new());
    collect(document, schema, &mut known, &mut required);
    // An object without members in its schema may be any object.
    if known.is_empty() {
        return Vec::new();
    }
    let mut wrong: Vec<String> = required
        .iter()
        .filter(|name| !object.contains_key(*name))
        .map(|name| format!("{at}.{name} is absent"))
        .collect();
    for (name, value) in object {
        let place = format!("{at}.{name}");
        match known.get(name) {
            Some(schema) => wrong.extend(differences(document, schema, value, &place)),
            None => wrong.push(format!("{place} is not documented")),
        }
    }
    wrong
}

/// Collects the members of an object and of the parts it is composed of.
fn collect(
    document: &Value,
    schema: &Value,
    known: &mut Map<String, Value>,
    required: &mut Vec<String>,
) {
    let schema = resolved(document, schema);
    for part in schema["allOf"].as_array().into_iter().flatten() {
        collect(document, part, known, required);
    }
    for (name, member) in schema["properties"].as_object().into_iter().flatten() {
        known.insert(name.clone(), member.clone());
    }
    let names = schema["required"].as_array().into_iter().flatten();
    required.extend(names.map(|name| name.as_str().unwrap().to_owned()));
}

#[test]
fn differences_from_the_schema_are_found() {
    let document = serde_json::json!({ "components": { "schemas": {
        "Colour": { "type": "string", "enum": ["red", "blue"] },
        "Lamp": { "allOf": [
            { "type": "object", "required": ["on"], "properties": { "on": { "type": "boolean" } } },
            { "type": "object", "properties": {
                "colours": { "type": "array", "items": { "$ref": "#/components/schemas/Colour" } },
                "watts": { "oneOf": [{ "type": "null" }, { "type": "number" }] } } }
        ] }
    } } });
    let lamp = serde_json::json!({ "$ref": "#/components/schemas/Lamp" });
    let wrong = |value: Value| differences(&document, &lamp, &value, "lamp");
    assert!(wrong(serde_json::json!({ "on": true, "colours": ["red"], "watts": null })).is_empty());
    assert_eq!(wrong(serde_json::json!({})), ["lamp.on is absent"]);
    assert_eq!(wrong(serde_json::json!({ "on": 1 })), ["lamp.on: 1 is not \"boolean\""]);
    assert_eq!(wrong(serde_json::json!({ "on": true, "x": 1 })), ["lamp.x is not documented"]);
    assert_eq!(wrong(serde_json::json!({ "on": true, "colours": ["red", "pink"] })).len(), 1);
    assert_eq!(wrong(serde_json::json!({ "on": true, "watts": "9" })).len(), 1);
}
