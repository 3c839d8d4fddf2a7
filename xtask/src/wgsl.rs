//! From SPIR-V to WGSL, through naga, in a form that browsers accept: their analysis (Tint's) must
//! see that every barrier is reached by all threads of a workgroup.
//!
//! Three things of what naga makes of rust-gpu's modules hide that, and are changed on the way.
//! Built-in values such as the number of a workgroup come through private variables, of which
//! nobody knows that they are the same for all threads: they become arguments. And failed checks of
//! indices into arrays of fixed length return: these checks go, because WGSL keeps indices in range
//! by itself (and no index is out of range, which the same bodies show on the CPU). And a word of
//! workgroup memory by which all threads decide alike is read between two barriers, for which WGSL
//! has a word.

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{
    AddressSpace, Arena, Block, Expression, Function, FunctionArgument, GlobalVariable, Handle,
    LocalVariable, Module, Range, Scalar, Statement, Type, TypeInner, UniqueArena,
};

/// Validates a module, changes it, validates it again and writes it.
pub fn translate(mut module: Module) -> Result<String, String> {
    validate(&module)?;
    for (_, function) in module.functions.iter_mut() {
        let body = std::mem::take(&mut function.body);
        function.body = without_failed_checks(body);
        let body = std::mem::take(&mut function.body);
        function.body = with_uniform_loads(body, function, &module.global_variables, &module.types);
    }
    pass_builtins(&mut module)?;
    naga::compact::compact(&mut module, naga::compact::KeepUnused::No);
    let info = validate(&module)?;
    naga::back::wgsl::write_string(&module, &info, naga::back::wgsl::WriterFlags::empty())
        .map_err(|e| format!("WGSL: {e}"))
}

fn validate(module: &Module) -> Result<ModuleInfo, String> {
    let capabilities = Capabilities::FLOAT64 | Capabilities::SHADER_INT64;
    Validator::new(ValidationFlags::all(), capabilities)
        .validate(module)
        .map_err(|e| format!("naga: {}", e.emit_to_string("")))
}

/// Without `if in_range {} else { return; }`.
fn without_failed_checks(block: Block) -> Block {
    let mut out = Block::with_capacity(block.len());
    for (mut statement, span) in block.span_into_iter() {
        let is_check = matches!(&statement, Statement::If { accept, reject, .. }
            if accept.is_empty() && matches!(&reject[..], [Statement::Return { value: None }]));
        if is_check {
            continue;
        }
        for inner in blocks_of(&mut statement) {
            *inner = without_failed_checks(std::mem::take(inner));
        }
        out.push(statement, span);
    }
    out
}

/// With `workgroupUniformLoad`, which is a barrier, a load from workgroup memory and a barrier, for
/// those three: its result is the same for all threads, so that they may decide by it whether they
/// come to the next barrier.
fn with_uniform_loads(
    block: Block,
    function: &mut Function,
    globals: &Arena<GlobalVariable>,
    types: &UniqueArena<Type>,
) -> Block {
    let is_barrier = |s: &Statement| matches!(s, Statement::ControlBarrier(_));
    let mut out = Block::with_capacity(block.len());
    let mut rest = block.span_into_iter().peekable();
    while let Some((mut statement, span)) = rest.next() {
        for inner in blocks_of(&mut statement) {
            *inner = with_uniform_loads(std::mem::take(inner), function, globals, types);
        }
        let before = matches!(out.last(), Some(s) if is_barrier(s));
        let after = rest.peek().is_some_and(|(s, _)| is_barrier(s));
        match &statement {
            Statement::Emit(range) if before && after => {
                match uniform_load(range, function, globals, types) {
                    Some(UniformLoad { before, pointer, result }) => {
                        out.cull(out.len() - 1..);
                        rest.next();
                        if let Some(others) = before {
                            out.push(Statement::Emit(others), span);
                        }
                        out.push(Statement::WorkGroupUniformLoad { pointer, result }, span);
                    }
                    None => out.push(statement, span),
                }
            }
            _ => out.push(statement, span),
        }
    }
    out
}

/// The blocks inside a statement.
fn blocks_of(statement: &mut Statement) -> Vec<&mut Block> {
    match statement {
        Statement::If { accept, reject, .. } => vec![accept, reject],
        Statement::Loop { body, continuing, .. } => vec![body, continuing],
        Statement::Block(block) => vec![block],
        Statement::Switch { cases, .. } => cases.iter_mut().map(|case| &mut case.body).collect(),
        _ => Vec::new(),
    }
}

/// A word of workgroup memory that is loaded between two barriers.
struct UniformLoad {
    /// Expressions emitted before the load.
    before: Option<Range<Expression>>,
    /// Pointer to the word.
    pointer: Handle<Expression>,
    /// The word.
    result: Handle<Expression>,
}

/// The load that ends `range`, if all before it computes a pointer to workgroup memory. Its result
/// becomes that of another statement.
fn uniform_load(
    range: &Range<Expression>,
    function: &mut Function,
    globals: &Arena<GlobalVariable>,
    types: &UniqueArena<Type>,
) -> Option<UniformLoad> {
    let last = range.clone().last()?;
    let Expression::Load { pointer } = function.expressions[last] else { return None };
    let mut place = pointer;
    while let Expression::Access { base, .. } | Expression::AccessIndex { base, .. } =
        function.expressions[place]
    {
        place = base;
    }
    let Expression::GlobalVariable(global) = function.expressions[place] else { return None };
    let is_load = |e: Handle<_>| matches!(function.expressions[e], Expression::Load { .. });
    if globals[global].space != AddressSpace::WorkGroup
        || range.clone().filter(|&e| is_load(e)).count() > 1
    {
        return None;
    }
    let word = Type { name: None, inner: TypeInner::Scalar(Scalar::U32) };
    let ty = types.get(&word)?;
    function.expressions[last] = Expression::WorkGroupUniformLoadResult { ty };
    let indices = range.index_range();
    let others = indices.start..indices.end - 1;
    let before =
        (!others.is_empty()).then(|| Range::from_index_range(others, &function.expressions));
    Some(UniformLoad { before, pointer, result: last })
}

/// The entry point stores built-in values in private variables and calls a function that reads
/// them; now it calls it with them.
fn pass_builtins(module: &mut Module) -> Result<(), String> {
    let entry = &mut module.entry_points[0].function;
    let mut values: Vec<(Handle<GlobalVariable>, Handle<Expression>)> = Vec::new();
    let mut body = Block::new();
    for (mut statement, span) in std::mem::take(&mut entry.body).span_into_iter() {
        match &mut statement {
            Statement::Store { pointer, value } => match entry.expressions[*pointer] {
                Expression::GlobalVariable(global)
                    if module.global_variables[global].space == AddressSpace::Private =>
                {
                    values.push((global, *value));
                    continue;
                }
                _ => {
                    return Err(
                        "an entry point that stores elsewhere than in private variables".into()
                    );
                }
            },
            Statement::Call { function, arguments, .. } if arguments.is_empty() => {
                arguments.extend(values.iter().map(|v| v.1));
                take_builtins(&mut module.functions[*function], &values, &module.global_variables);
            }
            Statement::Emit(_) | Statement::Return { value: None } => {}
            _ => return Err("an entry point that does more than call a function".into()),
        }
        body.push(statement, span);
    }
    entry.body = body;
    Ok(())
}

/// Makes local variables, which arguments fill, of private ones.
fn take_builtins(
    function: &mut Function,
    values: &[(Handle<GlobalVariable>, Handle<Expression>)],
    globals: &Arena<GlobalVariable>,
) {
    let span = naga::Span::UNDEFINED;
    let mut body = Block::new();
    for &(global, _) in values {
        let GlobalVariable { name, ty, .. } = globals[global].clone();
        let local = function
            .local_variables
            .append(LocalVariable { name: name.clone(), ty, init: None }, span);
        function.arguments.push(FunctionArgument { name, ty, binding: None });
        let value = function
            .expressions
            .append(Expression::FunctionArgument(function.arguments.len() as u32 - 1), span);
        for (_, expression) in function.expressions.iter_mut() {
            if matches!(expression, Expression::GlobalVariable(g) if *g == global) {
                *expression = Expression::LocalVariable(local);
            }
        }
        let pointer = function.expressions.append(Expression::LocalVariable(local), span);
        body.push(Statement::Store { pointer, value }, span);
    }
    for (statement, span) in std::mem::take(&mut function.body).span_into_iter() {
        body.push(statement, span);
    }
    function.body = body;
}
