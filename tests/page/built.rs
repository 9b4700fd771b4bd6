//! What the program carries is what the sources give.

use std::fs;

use crate::script::{node, page_folder};

#[test]
fn the_built_page_is_that_of_the_sources() {
    let folder = tempfile::tempdir().unwrap();
    let built = node().arg("build.mjs").arg(folder.path()).status().unwrap();
    assert!(built.success());
    let mut names = Vec::new();
    for entry in fs::read_dir(page_folder().join("dist")).unwrap() {
        let name = entry.unwrap().file_name();
        let [carried, made] = [page_folder().join("dist"), folder.path().to_owned()]
            .map(|folder| fs::read(folder.join(&name)).unwrap());
        assert!(
            carried == made,
            "{name:?} is not what its sources give: npm run build, in web/bench"
        );
        names.push(name);
    }
    assert_eq!(names.len(), 4, "{names:?}");
    for name in ["bench.js", "bench.css", "index.html"] {
        let text = fs::read_to_string(folder.path().join(name)).unwrap();
        // Comments of libraries name their homes, and SVG its name space; nothing is asked of them.
        for place in ["src=\"http", "href=\"http", "url(http", "@import", "import(\"http"] {
            assert!(!text.contains(place), "{name} looks elsewhere: {place}");
        }
    }
}
