//! What is set how.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use crate::equations::names::symbol;
use crate::equations::{Formula, lines, tag};

fn latex(text: &str) -> String {
    text.parse::<Formula>().unwrap_or_else(|error| panic!("{text}: {error}")).latex()
}

#[test]
fn symbols_in_latex() {
    for (name, expected) in [
        ("x", "x"),
        ("theta", r"\theta"),
        ("theta_1", r"\theta_{1}"),
        ("theta1", r"\theta_{1}"),
        ("Omega_x", r"\Omega_{x}"),
        ("θ2", r"\theta_{2}"),
        ("v_B_N_x", "v_{B,N,x}"),
        ("v1", "v_{1}"),
        ("v12_rel", r"v_{12,\mathrm{rel}}"),
        ("mass", r"\mathrm{mass}"),
        ("mass_2", r"\mathrm{mass}_{2}"),
        ("m_theta", r"m_{\theta}"),
        ("m[3]", "m_{3}"),
        ("m[3][1]", "m_{3,1}"),
        ("dot_x", r"\dot{x}"),
        ("dot(x)", r"\dot{x}"),
        ("dot(theta_1)", r"\dot{\theta}_{1}"),
        ("dot(dot_x)", r"\ddot{x}"),
        ("ddot(x)", r"\ddot{x}"),
        ("dot_swing", r"\dot{\mathrm{swing}}"),
        ("lambda(no_slip_along)", r"\lambda_{\mathrm{no\_slip\_along}}"),
        ("f(height)", r"f_{\mathrm{height}}"),
        ("phi(contact)", r"\phi_{\mathrm{contact}}"),
        ("M_d", "M_{d}"),
        ("h_u*", "h_{u}^{*}"),
        ("h*", "h^{*}"),
        ("c0*", "c_{0}^{*}"),
        ("a_u", "a_{u}"),
        ("a0", "a_{0}"),
        ("T", "T"),
        ("e12", "e_{12}"),
        ("PI", r"\pi"),
        ("pi", r"\mathrm{pi}"),
        ("r#type", r"\mathrm{type}"),
        ("größe_1", r"\text{größe}_{1}"),
        ("ж", r"\text{ж}"),
        ("x_", r"\mathrm{x\_}"),
        ("a__b", r"\mathrm{a\_\_b}"),
        ("dot_", r"\mathrm{dot\_}"),
        ("dot_2", r"\mathrm{dot}_{2}"),
    ] {
        assert_eq!(symbol(name), expected, "{name}");
    }
}

#[test]
fn formulas_in_latex() {
    for (text, expected) in [
        ("2*m*r", "2 m r"),
        ("m/2", r"\frac{m}{2}"),
        ("3*x/2", r"\frac{3 x}{2}"),
        ("-x/y/z", r"-\frac{x}{y z}"),
        ("a/b*c", r"\frac{a c}{b}"),
        ("a/(b*c)/(d + e)", r"\frac{a}{b c \left(d + e\right)}"),
        ("(a + b)/2", r"\frac{a + b}{2}"),
        ("a/(b/c)", r"\frac{a}{\frac{b}{c}}"),
        ("2*3*x", r"2 \cdot 3 x"),
        ("x*2", "2 x"),
        ("2*powi(3, 2)", r"2 \cdot 3^{2}"),
        ("mass*length", r"\mathrm{mass} \, \mathrm{length}"),
        ("mass*(a + b)", r"\mathrm{mass} \cdot \left(a + b\right)"),
        ("m*(a + b)", r"m \left(a + b\right)"),
        ("a - (b - c)", r"a - \left(b - c\right)"),
        ("-(a + b)*c", r"-\left(a + b\right) c"),
        ("a*(-b)", r"a \left(-b\right)"),
        ("powi(r_1, 2)", "r_{1}^{2}"),
        ("powi(dot_x, 2)", r"\dot{x}^{2}"),
        ("powi(a + b, 2)", r"\left(a + b\right)^{2}"),
        ("powi(a/b, 2)", r"\left(\frac{a}{b}\right)^{2}"),
        ("powi(powi(a, 2), 3)", r"\left(a^{2}\right)^{3}"),
        ("sin(x)", r"\sin x"),
        ("sin(theta)*r", r"r \sin\theta"),
        ("sin(theta)*(a + b)*2", r"2 \left(a + b\right) \sin\theta"),
        ("sin(theta)*cos(phi_1)", r"\sin\theta \cos\phi_{1}"),
        ("sin(a1 - a2)", r"\sin\left(a_{1} - a_{2}\right)"),
        ("powi(sin(theta), 2)", r"\sin^{2}\theta"),
        ("powi(cos(2*x), 3)*r", r"r \cos^{3}\left(2 x\right)"),
        ("powi(sin(x), -1)", r"\left(\sin x\right)^{-1}"),
        ("powi(ln(x), 2)", r"\left(\ln x\right)^{2}"),
        ("asin(x)", r"\arcsin x"),
        ("sqrt(powi(x, 2) + 1)", r"\sqrt{x^{2} + 1}"),
        ("powi(sqrt(x), 3)", r"\left(\sqrt{x}\right)^{3}"),
        ("abs(x - y)", r"\left|x - y\right|"),
        ("sign(x)*y", r"y \operatorname{sgn}x"),
        ("exp(-k*t)", r"\exp\left(-k t\right)"),
        ("powf(x, 3/2)", r"x^{\frac{3}{2}}"),
        ("atan2(y, x)", r"\mathrm{atan2}\left(y, x\right)"),
        ("m*road(s)", r"m \, \mathrm{road}\left(s\right)"),
        ("slope_of(s)", r"\mathrm{slope\_of}\left(s\right)"),
        ("PI/2", r"\frac{\pi}{2}"),
        ("1.5e-3*x", r"1.5 \cdot 10^{-3} x"),
        ("if a < 0 { -b } else { c }", r"\begin{cases} -b & \text{if } a < 0 \\ c & \text{otherwise} \end{cases}"),
        ("[x, 0]", r"\begin{bmatrix} x \\ 0 \end{bmatrix}"),
        ("[[a, 0], [0, b]]", r"\begin{bmatrix} a & 0 \\ 0 & b \end{bmatrix}"),
    ] {
        assert_eq!(latex(text), expected, "{text}");
    }
    let wide = latex("[[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10]]");
    assert!(wide.starts_with(r"\left[\begin{array}{ccccccccccc} 0 & 1"), "bmatrix has ten columns: {wide}");
}

#[test]
fn long_sums_are_set_in_lines() {
    let term = "a*sin(theta_1)*powi(dot_x, 2)";
    let long = format!("{term} - {}", [term; 11].join(" + "));
    let lines = lines(&long);
    // a, \sin, \theta, 1, \dot, x, 2 and a sign: eight characters a term.
    assert_eq!(lines.iter().map(|line| line.matches("sin").count()).collect::<Vec<_>>(), [10, 2]);
    assert!(lines[0].starts_with(r"a \dot{x}^{2} \sin\theta_{1} - a"), "{}", lines[0]);
    assert!(lines[1].starts_with(" + a"), "{}", lines[1]);
    assert_eq!(lines.concat(), latex(&long));
}

#[test]
fn a_text_that_is_no_formula_is_shown_all_the_same() {
    assert_eq!(lines("so & so_2 …"), [r"\text{so \& so\_2 \ldots{}}"]);
    for (source, latex) in [("(5.6)", r" \tag{5.6}"), ("", ""), ("see A_1", r" \tag*{see A\_1}")] {
        assert_eq!(tag(source), latex);
    }
}
