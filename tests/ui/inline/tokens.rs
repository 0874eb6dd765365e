//! What the compiler's own lexer accepts but the language does not.
use basis_runtime::basis;

basis! {
    family Glyphs {
        domain 0 <= t <= 1;
        b[0] = 'a';
        b[1] = "t";
        b[2] = 0x10;
        b[3] = t % 2;
    }
    lemma Later {}
}

fn main() {}
