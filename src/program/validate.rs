//! Validation of a linked program by naga, with errors located in the original files.

use std::error::Error;

use naga::Module;
use naga::valid::{Capabilities, ValidationFlags, Validator};

use super::ProgramError;
use super::linked::LinkedProgram;

/// Parses the program with naga and validates it completely.
///
/// # Errors
///
/// Returns [`ProgramError::Invalid`] if the WGSL is not valid, or has a variable that is too large.
pub fn validated(linked: &LinkedProgram) -> Result<Module, ProgramError> {
    let at = |spans: &mut dyn Iterator<Item = naga::Span>, message: String| {
        // The shortest span that naga reports is the error; longer spans are its context.
        let spans = spans.filter_map(naga::Span::to_range);
        let place = spans.min_by_key(ExactSizeIterator::len).map_or(linked.source.len(), |span| span.start);
        ProgramError::invalid(linked.place(place), message)
    };
    let module = naga::front::wgsl::parse_str(&linked.source).map_err(|error| {
        let message = [error.message()].into_iter().chain(error.notes()).collect::<Vec<_>>().join("; ");
        at(&mut error.labels().map(|(span, _)| span).take(1), message)
    })?;
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::default() | Capabilities::FLOAT64);
    validator.validate(&module).map_err(|error| {
        let first: Option<&dyn Error> = Some(error.as_inner());
        let chain = std::iter::successors(first, |error: &&dyn Error| (*error).source());
        let message = chain.map(ToString::to_string).collect::<Vec<_>>().join(": ");
        at(&mut error.spans().map(|(span, _)| *span), message)
    })?;
    match huge(&module) {
        Some((span, bytes)) => {
            let message = format!("this variable takes {bytes} bytes, more than the limit of {MOST} bytes per ray");
            Err(at(&mut std::iter::once(span), message))
        }
        None => Ok(module),
    }
}

/// The largest size in bytes of a private variable; larger ones make drivers spill, crash or hang.
const MOST: u32 = 16_384;

/// Returns a variable that is too large, and its size.
fn huge(module: &Module) -> Option<(naga::Span, u32)> {
    let size = |ty| module.types[ty].inner.size(module.to_ctx());
    let private = module.global_variables.iter().filter(|(_, global)| global.space == naga::AddressSpace::Private);
    let private = private.map(|(handle, global)| (module.global_variables.get_span(handle), size(global.ty)));
    let functions = module.functions.iter().map(|(_, function)| function);
    let functions = functions.chain(module.entry_points.iter().map(|entry| &entry.function));
    let local = |function: &'_ naga::Function| -> Vec<_> {
        let all = function.local_variables.iter();
        all.map(|(handle, own)| (function.local_variables.get_span(handle), size(own.ty))).collect()
    };
    private.chain(functions.flat_map(local)).find(|(_, bytes)| *bytes > MOST)
}
