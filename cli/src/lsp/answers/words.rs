//! The colours of words: semantic tokens.

use basis_engine::query::{SymbolKind, TokenKind, WordKind, word};
use lsp_types::{SemanticToken, SemanticTokenType, SemanticTokensLegend};

use crate::lsp::workspace::Text;

const TYPES: [SemanticTokenType; 9] = [
    SemanticTokenType::KEYWORD,
    SemanticTokenType::TYPE,
    SemanticTokenType::FUNCTION,
    SemanticTokenType::PARAMETER,
    SemanticTokenType::VARIABLE,
    SemanticTokenType::PROPERTY,
    SemanticTokenType::NUMBER,
    SemanticTokenType::STRING,
    SemanticTokenType::COMMENT,
];

/// The kinds of words, in the order in which the answers count them.
pub(in crate::lsp) fn legend() -> SemanticTokensLegend {
    SemanticTokensLegend { token_types: TYPES.to_vec(), token_modifiers: Vec::new() }
}

/// The words of a text, each relative to the one before it.
pub(in crate::lsp) fn tokens(text: &Text) -> Vec<SemanticToken> {
    let document = &text.document;
    let mut all = Vec::new();
    let mut last = lsp_types::Position::default();
    let mut names = document.occurrences.iter().peekable();
    for token in &document.tokens {
        while names.next_if(|o| o.range.start < token.range.start).is_some() {}
        let name = names.peek().filter(|o| o.range == token.range);
        let symbol = name.and_then(|o| o.symbol).map(|s| document.symbols[s].kind);
        let content = token.text(&document.text);
        let kind = match (token.kind, symbol) {
            (TokenKind::Word, Some(kind)) => of_symbol(kind),
            (TokenKind::Word, None) => match word(content).map(|w| w.kind) {
                Some(WordKind::Property) => SemanticTokenType::PROPERTY,
                Some(WordKind::Function) => SemanticTokenType::FUNCTION,
                Some(_) => SemanticTokenType::KEYWORD,
                // A family of another spec.
                None => SemanticTokenType::TYPE,
            },
            (TokenKind::Number, _) => SemanticTokenType::NUMBER,
            (TokenKind::Quoted, _) => SemanticTokenType::STRING,
            (TokenKind::Comment | TokenKind::Doc, _) => SemanticTokenType::COMMENT,
            (TokenKind::Sign | TokenKind::Open | TokenKind::Close, _) => continue,
        };
        let Some(token_type) = TYPES.iter().position(|t| *t == kind) else { continue };
        // A token of the protocol stands on one line.
        let mut start = token.range.start;
        for line in content.split('\n') {
            let at = text.position(start);
            start += line.len() + 1;
            let length = line.encode_utf16().count() as u32;
            if length == 0 {
                continue;
            }
            let delta_line = at.line - last.line;
            let delta_start = if delta_line == 0 { at.character - last.character } else { at.character };
            let token_type = token_type as u32;
            all.push(SemanticToken {
                delta_line,
                delta_start,
                length,
                token_type,
                token_modifiers_bitset: 0,
            });
            last = at;
        }
    }
    all
}

const fn of_symbol(kind: SymbolKind) -> SemanticTokenType {
    match kind {
        SymbolKind::Family | SymbolKind::Theorem | SymbolKind::Join => SemanticTokenType::TYPE,
        SymbolKind::Functions | SymbolKind::Patch => SemanticTokenType::FUNCTION,
        SymbolKind::Shape | SymbolKind::Scalar | SymbolKind::Order => SemanticTokenType::PARAMETER,
        SymbolKind::Domain | SymbolKind::Index | SymbolKind::Let => SemanticTokenType::VARIABLE,
    }
}
