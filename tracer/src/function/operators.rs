//! SDL: `+ - * / < <= = != >= > & |` and the float functions that may stand in a function's body.

/// Operators and float functions of one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)] // named after their keywords
pub enum Unary {
    Neg,
    Abs,
    Acos,
    Acosh,
    Asin,
    Asinh,
    Atan,
    Atanh,
    Ceil,
    Cos,
    Cosh,
    Degrees,
    Exp,
    Floor,
    Int,
    Ln,
    Log,
    Radians,
    Sin,
    Sinh,
    Sqrt,
    Tan,
    Tanh,
}

/// Operators and float functions of two operands; `min` and `max` of more are chains of these.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    Less,
    LessEqual,
    Equal,
    NotEqual,
    GreaterEqual,
    Greater,
    And,
    Or,
    Atan2,
    Max,
    Min,
    Mod,
    Pow,
}

impl Unary {
    /// By keyword.
    pub fn named(word: &str) -> Option<Unary> {
        Some(match word {
            "neg" => Unary::Neg,
            "abs" => Unary::Abs,
            "acos" => Unary::Acos,
            "acosh" => Unary::Acosh,
            "asin" => Unary::Asin,
            "asinh" => Unary::Asinh,
            "atan" => Unary::Atan,
            "atanh" => Unary::Atanh,
            "ceil" => Unary::Ceil,
            "cos" => Unary::Cos,
            "cosh" => Unary::Cosh,
            "degrees" => Unary::Degrees,
            "exp" => Unary::Exp,
            "floor" => Unary::Floor,
            "int" => Unary::Int,
            "ln" => Unary::Ln,
            "log" => Unary::Log,
            "radians" => Unary::Radians,
            "sin" => Unary::Sin,
            "sinh" => Unary::Sinh,
            "sqrt" => Unary::Sqrt,
            "tan" => Unary::Tan,
            "tanh" => Unary::Tanh,
            _ => return None,
        })
    }

    /// The value.
    #[inline]
    pub fn apply(self, a: f64) -> f64 {
        match self {
            Unary::Neg => -a,
            Unary::Abs => a.abs(),
            Unary::Acos => a.acos(),
            Unary::Acosh => a.acosh(),
            Unary::Asin => a.asin(),
            Unary::Asinh => a.asinh(),
            Unary::Atan => a.atan(),
            Unary::Atanh => a.atanh(),
            Unary::Ceil => a.ceil(),
            Unary::Cos => a.cos(),
            Unary::Cosh => a.cosh(),
            Unary::Degrees => a.to_degrees(),
            Unary::Exp => a.exp(),
            Unary::Floor => a.floor(),
            Unary::Int => truncated(a),
            Unary::Ln => a.ln(),
            Unary::Log => a.log10(),
            Unary::Radians => a.to_radians(),
            Unary::Sin => a.sin(),
            Unary::Sinh => a.sinh(),
            Unary::Sqrt => a.sqrt(),
            Unary::Tan => a.tan(),
            Unary::Tanh => a.tanh(),
        }
    }
}

/// `int` knows 32 bits; what does not fit is the smallest of them.
fn truncated(a: f64) -> f64 {
    if a.abs() < 2_147_483_648.0 {
        a.trunc()
    } else {
        f64::from(i32::MIN)
    }
}

impl Binary {
    /// By operator or keyword.
    pub fn named(word: &str) -> Option<Binary> {
        Some(match word {
            "+" => Binary::Add,
            "-" => Binary::Sub,
            "*" => Binary::Mul,
            "/" => Binary::Div,
            "<" => Binary::Less,
            "<=" => Binary::LessEqual,
            "=" => Binary::Equal,
            "!=" => Binary::NotEqual,
            ">=" => Binary::GreaterEqual,
            ">" => Binary::Greater,
            "&" => Binary::And,
            "|" => Binary::Or,
            "atan2" => Binary::Atan2,
            "max" => Binary::Max,
            "min" => Binary::Min,
            "mod" => Binary::Mod,
            "pow" => Binary::Pow,
            _ => return None,
        })
    }

    /// The value; comparisons are exact and give 1 or 0.
    #[inline]
    pub fn apply(self, a: f64, b: f64) -> f64 {
        let truth = |holds: bool| f64::from(u8::from(holds));
        match self {
            Binary::Add => a + b,
            Binary::Sub => a - b,
            Binary::Mul => a * b,
            Binary::Div => a / b,
            Binary::Less => truth(a < b),
            Binary::LessEqual => truth(a <= b),
            Binary::Equal => truth(a == b),
            Binary::NotEqual => truth(a != b),
            // What is not a number counts as greater.
            Binary::GreaterEqual => truth(!lt(a, b)),
            Binary::Greater => truth(!le(a, b)),
            Binary::And => truth(a != 0.0 && b != 0.0),
            Binary::Or => truth(a != 0.0 || b != 0.0),
            Binary::Atan2 => a.atan2(b),
            Binary::Max => {
                if b > a {
                    b
                } else {
                    a
                }
            }
            Binary::Min => {
                if a < b {
                    a
                } else {
                    b
                }
            }
            Binary::Mod => a % b,
            Binary::Pow => a.powf(b),
        }
    }
}

fn lt(a: f64, b: f64) -> bool {
    a < b
}

fn le(a: f64, b: f64) -> bool {
    a <= b
}
