//! WGSL and GLSL: valid for naga, and GLSL for the reference compiler too.

use basis_engine::emit::shader::Shader;
use basis_tests_targets::{cases, has, related_join, run, write};
use naga::front::{glsl, wgsl};
use naga::valid::{Capabilities, ValidationFlags, Validator};

fn validate(module: &naga::Module, name: &str) {
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    if let Err(error) = validator.validate(module) {
        panic!("{name}: {}", error.emit_to_string(""));
    }
}

/// All families together, so that no two have a name in common.
#[test]
fn wgsl_is_valid() {
    let families = cases().into_iter().map(|case| case.emit(&Shader::Wgsl));
    let text: String = families.chain([related_join(&Shader::Wgsl)]).collect();
    let module = wgsl::parse_str(&text).unwrap_or_else(|error| panic!("{}", error.emit_to_string(&text)));
    validate(&module, "WGSL");
    let kernels: Vec<&str> = module.entry_points.iter().map(|entry| entry.name.as_str()).collect();
    for case in cases() {
        let own = case.code(&Shader::Wgsl).name;
        let own = own.strip_suffix('_').unwrap_or(&own);
        assert!(kernels.contains(&format!("{own}_eval_n").as_str()), "{kernels:?}");
    }
}

fn fragment_shader(version: &str) -> String {
    let families = cases().into_iter().map(|case| case.emit(&Shader::Glsl));
    let functions: String = families.chain([related_join(&Shader::Glsl)]).collect();
    format!(
        "#version {version}\nprecision highp float;\n{functions}\nout vec4 color;\nvoid main() {{\n    \
         vec4 points[4] = vec4[4](vec4(0.0), vec4(1.0), vec4(2.0), vec4(3.0));\n    \
         color = Cubic_eval(Cubic_bind(points), 0.5);\n}}\n"
    )
}

#[test]
fn glsl_is_valid() {
    let text = fragment_shader("450 core").replace("out vec4", "layout(location = 0) out vec4");
    let options = glsl::Options::from(naga::ShaderStage::Fragment);
    let module = glsl::Frontend::default().parse(&options, &text);
    let module = module.unwrap_or_else(|error| panic!("{}", error.emit_to_string(&text)));
    validate(&module, "GLSL");
}

#[test]
#[ignore = "needs glslangValidator"]
fn glsl_compiles() {
    if !has("glslangValidator", &["--version"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    for version in ["330 core", "450 core", "300 es", "320 es"] {
        write(folder.path(), "all.frag", &fragment_shader(version));
        run(folder.path(), "glslangValidator", &["all.frag"]);
    }
}
