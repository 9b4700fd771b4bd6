//! A section of the page: pictures, what they say, and the paper's values beside ours.

/// One figure of the report.
#[derive(Debug, Clone, Default)]
pub struct Section {
    /// Anchor in the page.
    pub id: &'static str,
    /// Headline.
    pub title: &'static str,
    /// Pictures.
    pub panels: Vec<Panel>,
    /// What is shown and what it says.
    pub caption: String,
    /// The paper's values beside ours.
    pub compared: Vec<Compared>,
}

/// A picture with a line above it.
#[derive(Debug, Clone)]
pub struct Panel {
    /// What this picture shows.
    pub title: String,
    /// The picture.
    pub svg: String,
    /// Whether it may share its line with others.
    pub narrow: bool,
}

/// A value of the paper and ours.
#[derive(Debug, Clone, PartialEq)]
pub struct Compared {
    /// Quantity, unit and circumstances.
    pub what: String,
    /// The paper's.
    pub paper: String,
    /// Ours.
    pub ours: String,
}

impl Panel {
    /// A picture as wide as the page.
    pub fn wide(title: impl Into<String>, svg: String) -> Self {
        Self { title: title.into(), svg, narrow: false }
    }

    /// A picture that may stand beside others.
    pub fn narrow(title: impl Into<String>, svg: String) -> Self {
        Self { title: title.into(), svg, narrow: true }
    }
}

impl Compared {
    /// A line of the comparison.
    pub fn new(what: impl Into<String>, paper: impl Into<String>, ours: impl Into<String>) -> Self {
        Self { what: what.into(), paper: paper.into(), ours: ours.into() }
    }
}
