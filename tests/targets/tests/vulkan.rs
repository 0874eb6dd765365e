//! WGSL, run by a Vulkan device: its functions, and the compute shader that comes with them. A software device such as
//! lavapipe will do; the test fails where there is none, so that `.ci/run` asks for it only after having installed one.

use std::fmt::Write as _;

use basis_engine::algebra::rational::Rational;
use basis_engine::emit::shader::Shader;
use basis_tests_targets::{
    Case, DIMENSION, Expected, Floats, Rounds, cases, compare, list, measured, orders,
};
use wgpu::util::{BufferInitDescriptor, DeviceExt as _};

/// A device with its queue.
struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
}

impl Gpu {
    fn new() -> Self {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()));
        let adapter = adapter.expect("a Vulkan device, such as that of mesa-vulkan-drivers");
        let wanted = wgpu::DeviceDescriptor { required_limits: adapter.limits(), ..Default::default() };
        let (device, queue) = pollster::block_on(adapter.request_device(&wanted)).expect("a device");
        Self { device, queue }
    }

    /// Runs an entry point once for each of `count` invocations; the last of the buffers, numbered as they are bound, is
    /// written, and returned.
    fn run(
        &self,
        text: &str,
        entry: &str,
        count: usize,
        inputs: &[(u32, Vec<f32>)],
        output: (u32, usize),
    ) -> Vec<f32> {
        let source = wgpu::ShaderSource::Wgsl(text.into());
        let module =
            self.device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some(entry), source });
        let pipeline = self.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(entry),
            layout: None,
            module: &module,
            entry_point: Some(entry),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        let size = output.1 as u64 * 4;
        let buffer = |usage| {
            self.device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size,
                usage,
                mapped_at_creation: false,
            })
        };
        let written = buffer(wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC);
        let back = buffer(wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
        let mut buffers: Vec<(u32, wgpu::Buffer)> = Vec::new();
        for (binding, numbers) in inputs {
            let contents: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
            let usage = wgpu::BufferUsages::STORAGE;
            let init = BufferInitDescriptor { label: None, contents: &contents, usage };
            buffers.push((*binding, self.device.create_buffer_init(&init)));
        }
        buffers.push((output.0, written.clone()));
        let entries: Vec<wgpu::BindGroupEntry<'_>> = buffers
            .iter()
            .map(|(binding, buffer)| wgpu::BindGroupEntry {
                binding: *binding,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        let group = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(0),
            entries: &entries,
        });
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(0, &group, &[]);
            pass.dispatch_workgroups(count.div_ceil(64) as u32, 1, 1);
        }
        encoder.copy_buffer_to_buffer(&written, 0, &back, 0, size);
        self.queue.submit([encoder.finish()]);
        back.slice(..).map_async(wgpu::MapMode::Read, |mapped| mapped.expect("memory that can be read"));
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("a device that answers");
        let bytes = back.slice(..).get_mapped_range().expect("memory that was mapped").to_vec();
        bytes.chunks_exact(4).map(|x| f32::from_le_bytes([x[0], x[1], x[2], x[3]])).collect()
    }
}

/// An entry point that writes all results of a sample, in the order of [`Case::expected`], and one that binds the points.
fn entry_points(case: &Case, own: &str, results: usize) -> String {
    let count = case.family.functions.len();
    let coordinates = case.steps().coordinates();
    let at = ["x", "y", "z", "w"][..coordinates].iter().map(|c| format!("show_at[id.x].{c}"));
    let at = at.collect::<Vec<_>>().join(", ");
    let shapes: Vec<String> = case.shapes.iter().map(|shape| format!("{shape:?}f, ")).collect();
    let shapes = shapes.concat();
    let point_shapes = if case.steps().is_quotient() { shapes.as_str() } else { "" };
    let points: Vec<String> =
        case.points().chunks(DIMENSION).map(|p| format!("vec4f({}, 0.0f, 0.0f)", list(p, "f"))).collect();
    let mut text = format!(
        "@group(0) @binding(4) var<storage, read> show_at: array<vec4f>;\n\
         @group(0) @binding(5) var<storage, read_write> show_results: array<f32>;\n\
         @group(0) @binding(6) var<storage, read_write> show_bound: array<vec4f>;\n\
         fn show_bind() -> array<vec4f, {bound}> {{ return {own}_bind({shapes}array<vec4f, {count}>({points})); }}\n\
         @compute @workgroup_size(64)\nfn bind_all(@builtin(global_invocation_id) id: vec3u) {{\n    \
         if (id.x == 0u) {{\n        let bound = show_bind();\n        \
         for (var k = 0u; k < {bound}u; k++) {{ show_bound[k] = bound[k]; }}\n    }}\n}}\n\
         @compute @workgroup_size(64)\nfn show(@builtin(global_invocation_id) id: vec3u) {{\n    \
         if (id.x >= arrayLength(&show_at)) {{ return; }}\n    \
         let bound = show_bind();\n    var next = id.x * {results}u;\n",
        bound = case.steps().bound(),
        points = points.join(", "),
    );
    let functions = |text: &mut String, name: &str| {
        let _ = writeln!(
            text,
            "    {{ let all = {own}_{name}({shapes}{at}); for (var k = 0u; k < {count}u; k++) {{ \
             show_results[next] = all[k]; next++; }} }}"
        );
    };
    let point = |text: &mut String, value: &str| {
        let _ = writeln!(
            text,
            "    {{ let p = {value}; show_results[next] = p.x; show_results[next + 1u] = p.y; next += 2u; }}"
        );
    };
    functions(&mut text, "values");
    if case.is_curve() {
        functions(&mut text, "derivatives");
        functions(&mut text, "second_derivatives");
        point(&mut text, &format!("{own}_eval({point_shapes}bound, {at})"));
        for k in 0..3 {
            point(&mut text, &format!("{own}_eval_with_derivatives({point_shapes}bound, {at})[{k}]"));
        }
    } else {
        let code = case.code(&Shader::Wgsl);
        let orders = orders(case.family.domain.len());
        for orders in &orders {
            functions(&mut text, &format!("partials_{}", code.along(orders)));
        }
        point(&mut text, &format!("{own}_eval({point_shapes}bound, {at})"));
        for orders in &orders {
            point(
                &mut text,
                &format!("{own}_eval_partial_{}({point_shapes}bound, {at})", code.along(orders)),
            );
        }
    }
    text + "}\n"
}

/// Each number as a line, as programs print them.
fn lines(numbers: &[f32]) -> String {
    let all: Vec<String> = numbers.iter().map(|x| format!("{:016x}", f64::from(*x).to_bits())).collect();
    all.join("\n")
}

/// The results of a case are within the proved bounds.
fn check(gpu: &Gpu, case: &Case) -> Result<(), String> {
    let own = case.code(&Shader::Wgsl).name;
    let (samples, mut expected) =
        (case.samples(Floats::Single), case.expected(Floats::Single, Floats::Single));
    if case.calls() || case.code(&Shader::Wgsl).has_ends_in_parts() {
        // (a − t) + b may be computed as (a + b) − t in WGSL: next to an end such as π/2, of which a + b has more digits
        // than a float, the error is small beside 1 only.
        let one = &measured() * &Rational::new(1, 1 << 23);
        for (_, tolerance) in expected.iter_mut().filter_map(|expected| expected.exact.as_mut()) {
            *tolerance += &one;
        }
    }
    let (functions, coordinates) = (case.family.functions.len(), case.steps().coordinates());
    // The points of contacts stand at the end.
    let (before, points) = if case.is_curve() {
        (3 * functions, 4)
    } else {
        let orders = orders(case.family.domain.len()).len() + 1;
        (orders * functions, orders)
    };
    let results = before + points * DIMENSION;
    let expected = &expected[..samples.len() * results];
    let text = case.emit(&Shader::Wgsl) + &entry_points(case, &own, results);
    let padded =
        |at: &Vec<f64>| -> [f32; 4] { std::array::from_fn(|k| at.get(k).map_or(0.0, |x| *x as f32)) };
    let all: Vec<f32> = samples.iter().flat_map(padded).collect();
    let shown = gpu.run(&text, "show", samples.len(), &[(4, all.clone())], (5, samples.len() * results));
    compare(&lines(&shown), expected, Rounds::Fused)?;

    let bound = gpu.run(&text, "bind_all", 1, &[], (6, case.steps().bound() * 4));
    let at = if coordinates == 1 { samples.iter().map(|at| at[0] as f32).collect() } else { all };
    let mut inputs = vec![(0, bound), (1, at)];
    if case.steps().is_quotient() && !case.shapes.is_empty() {
        inputs.push((3, case.shapes.iter().map(|shape| *shape as f32).collect()));
    }
    let kernel = format!("{}_eval_n", own.strip_suffix('_').unwrap_or(&own));
    let found = gpu.run(&text, &kernel, samples.len(), &inputs, (2, samples.len() * 4));
    let found: Vec<f32> = found.chunks(4).flat_map(|point| point[..DIMENSION].to_vec()).collect();
    let points: Vec<Expected> =
        expected.chunks(results).flat_map(|all| all[before..before + DIMENSION].to_vec()).collect();
    compare(&lines(&found), &points, Rounds::Fused).map_err(|error| format!("{kernel}: {error}"))
}

#[test]
#[ignore = "needs a Vulkan device"]
fn a_device_computes_what_is_proved() {
    let gpu = Gpu::new();
    let wrong: Vec<String> = cases().iter().filter_map(|case| check(&gpu, case).err()).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
