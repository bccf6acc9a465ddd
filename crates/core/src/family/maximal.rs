//! The largest interval or box around a point in which a family has the required statements.
