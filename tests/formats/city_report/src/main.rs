// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//! city_report FILE: what cjval says of a CityJSON file, as JSON.
fn main() {
    let path = std::env::args().nth(1).expect("usage: city_report FILE");
    let text = std::fs::read_to_string(&path).expect("a readable file");
    let report = cjval::CJValidator::from_str(&text).get_report(&path);
    println!("{}", serde_json::to_string(&report).expect("a report"));
}
