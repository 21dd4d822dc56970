use super::errors;
#[test]
fn none() {
    assert!(errors("struct A;").len() == 3);
}
