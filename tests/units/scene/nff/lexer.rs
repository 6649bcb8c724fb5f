use super::*;

#[test]
fn words_know_line_and_column() {
    let mut words = Lexer::new("s 1 2# no words here\r\n\n \t-3é x");
    let mut word = || words.next().map(|word| (word.text, word.place.line, word.place.column));
    assert_eq!(word(), Some(("s", 1, 1)));
    assert_eq!(word(), Some(("1", 1, 3)));
    assert_eq!(word(), Some(("2", 1, 5)));
    assert_eq!(word(), Some(("-3é", 3, 3)));
    assert_eq!(word(), Some(("x", 3, 7)));
    assert_eq!(word(), None);
}

#[test]
fn an_empty_text_and_a_lone_comment_have_no_words() {
    assert_eq!(Lexer::new("").next(), None);
    assert_eq!(Lexer::new("\u{feff}# s 1 2 3").next(), None);
}
