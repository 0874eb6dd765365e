//! Rules with the symmetries of a triangle or a tetrahedron, as classes of points that its symmetries exchange.
//!
//! Each rule solves the equations of the moments for the symmetric polynomials of its degree, which were solved by
//! Newton's method from random starts and refined with 50 digits; the numbers of points of each class are those of F. D.
//! Witherden, P. E. Vincent, "On the identification of symmetric quadrature rules for finite element methods",
//! Computers & Mathematics with Applications 69, 2015. A test computes all moments.

use alloc::vec::Vec;

use Orbit::{Centre, General, Median, Middle, Plane};

/// A class of points; all permutations of the coordinates.
enum Orbit {
    /// All coordinates are equal.
    Centre,
    /// All coordinates but one have this value: points on the lines from a corner through the centre.
    Median(f64),
    /// Of the four coordinates two have this value, the two others another one.
    Middle(f64),
    /// The coordinates of a triangle are these two and a third one.
    General(f64, f64),
    /// Of the four coordinates two have the first value, one has the second.
    Plane(f64, f64),
}

/// A rule in barycentric coordinates, with weights whose sum is 1.
pub(super) struct Rule {
    /// The coordinates, one point after the other.
    pub(super) points: Vec<f64>,
    pub(super) weights: Vec<f64>,
    pub(super) degree: usize,
}

/// The rule of the lowest degree that is not below this one.
#[inline]
pub(super) fn rule(corners: usize, degree: usize) -> Option<Rule> {
    let rules = match corners {
        3 => TRIANGLE,
        4 => TETRAHEDRON,
        _ => return None,
    };
    let &(degree, orbits) = rules.iter().find(|(d, _)| *d >= degree)?;
    let mut rule = Rule { points: Vec::new(), weights: Vec::new(), degree };
    for (weight, orbit) in orbits {
        let point: &[f64] = match *orbit {
            Centre => &[1.0 / corners as f64; 4][..corners],
            Median(a) => &[1.0 - (corners - 1) as f64 * a, a, a, a][..corners],
            Middle(a) => &[a, a, 0.5 - a, 0.5 - a],
            General(a, b) => &[a, b, 1.0 - a - b],
            Plane(a, b) => &[a, a, b, 1.0 - 2.0 * a - b],
        };
        permutations(point, &mut Vec::new(), &mut |point| {
            rule.points.extend_from_slice(point);
            rule.weights.push(*weight);
        });
    }
    Some(rule)
}

/// All different orders of the coordinates that are left.
fn permutations(left: &[f64], chosen: &mut Vec<f64>, each: &mut dyn FnMut(&[f64])) {
    if left.is_empty() {
        each(chosen);
    }
    for (i, &next) in left.iter().enumerate() {
        if left[..i].contains(&next) {
            continue;
        }
        let rest: Vec<f64> = left.iter().enumerate().filter(|&(j, _)| j != i).map(|(_, &c)| c).collect();
        chosen.push(next);
        permutations(&rest, chosen, each);
        chosen.pop();
    }
}

/// On triangles: the degree, and the weight and orbit of each class of points.
const TRIANGLE: &[(usize, &[(f64, Orbit)])] = &[
    // 1 point
    (1, &[(1.0, Centre)]),
    // 3 points
    (2, &[(0.333_333_333_333_333_3, Median(0.166_666_666_666_666_66))]),
    // 6 points
    (
        4,
        &[
            (0.223_381_589_678_011_47, Median(0.445_948_490_915_964_9)),
            (0.109_951_743_655_321_87, Median(0.091_576_213_509_770_74)),
        ],
    ),
    // 7 points
    (
        5,
        &[
            (0.225, Centre),
            (0.125_939_180_544_827_14, Median(0.101_286_507_323_456_34)),
            (0.132_394_152_788_506_2, Median(0.470_142_064_105_115_1)),
        ],
    ),
    // 12 points
    (
        6,
        &[
            (0.080_731_089_593_030_98, Median(0.480_137_964_112_215_04)),
            (0.171_333_124_152_981_02, Median(0.219_429_982_549_782_96)),
            (0.040_634_559_793_660_666, General(0.019_371_724_361_240_787, 0.839_009_259_714_791)),
        ],
    ),
    // 15 points
    (
        7,
        &[
            (0.050_909_610_887_159_146, Median(0.063_511_646_774_314_84)),
            (0.068_378_098_078_353_24, Median(0.407_437_094_613_342_43)),
            (0.084_369_738_581_439_17, Median(0.214_914_090_723_341_1)),
            (0.064_837_942_893_190_89, General(0.312_841_089_198_166_83, 0.647_042_868_816_229_9)),
        ],
    ),
    // 16 points
    (
        8,
        &[
            (0.144_315_607_677_787_17, Centre),
            (0.032_458_497_623_198_08, Median(0.050_547_228_317_030_98)),
            (0.103_217_370_534_718_24, Median(0.170_569_307_751_760_2)),
            (0.095_091_634_267_284_62, Median(0.459_292_588_292_723_2)),
            (0.027_230_314_174_434_993, General(0.263_112_829_634_638_1, 0.008_394_777_409_957_605)),
        ],
    ),
    // 19 points
    (
        9,
        &[
            (0.097_135_796_282_798_84, Centre),
            (0.031_334_700_227_139_07, Median(0.489_682_519_198_737_6)),
            (0.025_577_675_658_698_03, Median(0.044_729_513_394_452_71)),
            (0.079_647_738_927_210_25, Median(0.188_203_535_619_032_72)),
            (0.077_827_541_004_774_28, Median(0.437_089_591_492_936_64)),
            (0.043_283_539_377_289_376, General(0.221_962_989_160_765_7, 0.036_838_412_054_736_286)),
        ],
    ),
    // 25 points
    (
        10,
        &[
            (0.081_743_329_146_285_97, Centre),
            (0.013_352_968_813_149_567, Median(0.032_055_373_216_943_51)),
            (0.045_957_963_604_744_73, Median(0.142_161_101_056_564_38)),
            (0.063_904_906_396_424_04, General(0.530_054_118_927_344, 0.148_132_885_783_820_56)),
            (0.034_184_648_162_959_43, General(0.369_146_781_827_810_97, 0.601_233_328_683_459_2)),
            (0.025_297_757_707_288_385, General(0.163_701_733_737_182_5, 0.807_930_600_922_879)),
        ],
    ),
];

/// On tetrahedra.
const TETRAHEDRON: &[(usize, &[(f64, Orbit)])] = &[
    // 1 point
    (1, &[(1.0, Centre)]),
    // 4 points
    (2, &[(0.25, Median(0.138_196_601_125_010_5))]),
    // 8 points
    (
        3,
        &[
            (0.091_204_411_766_056_7, Median(0.333_104_399_930_035_93)),
            (0.158_795_588_233_943_3, Median(0.124_649_596_263_155_87)),
        ],
    ),
    // 14 points
    (
        5,
        &[
            (0.112_687_925_718_015_85, Median(0.310_885_919_263_300_6)),
            (0.073_493_043_116_361_96, Median(0.092_735_250_310_891_22)),
            (0.042_546_020_777_081_466, Middle(0.454_496_295_874_350_36)),
        ],
    ),
    // 24 points
    (
        6,
        &[
            (0.055_357_181_543_654_724, Median(0.322_337_890_142_275_5)),
            (0.039_922_750_258_167_494, Median(0.214_602_871_259_152_03)),
            (0.010_077_211_055_320_643, Median(0.040_673_958_534_611_35)),
            (0.048_214_285_714_285_716, Plane(0.063_661_001_875_017_53, 0.269_672_331_458_315_8)),
        ],
    ),
];
