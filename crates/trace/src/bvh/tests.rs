//! What must hold of every hierarchy.

use super::walk::Sight;
use super::*;
use proptest::prelude::*;
use std::collections::BTreeMap;

/// The exact answer to whether a ray meets a box at a positive distance: slabs in double precision.
fn meets(bounds: &Bounds, origin: DVec3, direction: DVec3) -> Option<f64> {
    let (mut near, mut far) = (0.0_f64, f64::INFINITY);
    for axis in 0..3 {
        let (low, high) = (bounds.low[axis] - origin[axis], bounds.high[axis] - origin[axis]);
        if direction[axis] == 0.0 {
            if low > 0.0 || high < 0.0 {
                return None;
            }
            continue;
        }
        let (a, b) = (low / direction[axis], high / direction[axis]);
        near = near.max(a.min(b));
        far = far.min(a.max(b));
    }
    (near <= far).then_some(near)
}

/// Everything that the nodes say: each item is in one leaf, each box holds its children's, no way is too long.
fn check(bounds: &[Bounds], bvh: &Bvh, order: &[u32]) {
    let mut sorted = order.to_vec();
    sorted.sort_unstable();
    assert_eq!(sorted, (0..bounds.len() as u32).collect::<Vec<_>>());
    if bounds.is_empty() {
        assert!(bvh.nodes().is_empty() && bvh.bounds().is_none());
        return;
    }
    assert_eq!(bvh.bounds(), bounds.iter().copied().reduce(Bounds::union));
    let all = Bounds { low: DVec3::NEG_INFINITY, high: DVec3::INFINITY };
    let mut open = vec![(0_usize, all, 1_usize)];
    let mut leaves = BTreeMap::new();
    let mut nodes = 0;
    while let Some((node, parent, depth)) = open.pop() {
        assert!(depth <= MAX_DEPTH);
        nodes += 1;
        let node = &bvh.nodes()[node];
        for child in 0..WIDTH {
            let [low, high] =
                [&node.low, &node.high].map(|side| DVec3::from([0, 1, 2].map(|axis| f64::from(side[axis][child]))));
            if low.x > high.x {
                assert_eq!((low, high), (DVec3::INFINITY, DVec3::NEG_INFINITY));
                continue;
            }
            let around = Bounds { low: low + bvh.origin(), high: high + bvh.origin() };
            assert!(low.cmpge(parent.low).all() && high.cmple(parent.high).all(), "within its parent's box");
            match node.children[child].entry() {
                Entry::Inner(inner) => open.push((inner as usize, Bounds { low, high }, depth + 1)),
                Entry::Leaf { first, count } => {
                    assert_eq!(leaves.insert(first, count), None);
                    for &item in &order[first as usize..(first + count) as usize] {
                        let item = bounds[item as usize];
                        assert!(around.low.cmple(item.low).all() && around.high.cmpge(item.high).all());
                    }
                }
            }
        }
    }
    assert_eq!(nodes, bvh.nodes().len());
    let mut end = 0;
    for (first, count) in leaves {
        assert_eq!(first, end, "the leaves follow each other without gaps");
        end += count;
    }
}

fn visited(bvh: &Bvh, order: &[u32], origin: DVec3, direction: DVec3, limit: f64) -> Vec<u32> {
    let mut items = Vec::new();
    let sight = Sight::new(bvh, origin, direction, bvh.margin().at(origin));
    bvh.visit(&sight, limit, |first, count, limit| {
        items.extend_from_slice(&order[first as usize..(first + count) as usize]);
        limit
    });
    items.sort_unstable();
    items
}

fn point(scale: f64) -> impl Strategy<Value = DVec3> {
    [-scale..scale, -scale..scale, -scale..scale].prop_map(DVec3::from)
}

/// Points of very different sizes, some of them exactly 0, some equal.
fn any_point() -> impl Strategy<Value = DVec3> {
    let coordinate = || prop_oneof![Just(0.0), Just(1.0), -1e9..1e9, -1.0..1.0, -1e-9..1e-9];
    [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from)
}

fn any_size() -> impl Strategy<Value = DVec3> {
    let coordinate = || prop_oneof![Just(0.0), 0.0..1e9, 0.0..1.0, 0.0..1e-9];
    [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from)
}

proptest! {
    /// Every item whose own box the ray meets is visited, and each once.
    #[test]
    fn nothing_is_missed(
        boxes in prop::collection::vec((point(10.0), point(2.0)), 0..200),
        origin in point(15.0),
        target in point(5.0),
        limit in 1.0..100.0,
    ) {
        let bounds: Vec<Bounds> = boxes.iter().map(|&(at, size)| Bounds::of([at, at + size])).collect();
        nothing_missed(&bounds, origin, (target - origin).normalize(), limit)?;
    }

    /// The same where 10⁹ and 10⁻⁹ stand side by side, boxes are flat or points, and rays run along axes and faces.
    #[test]
    fn nothing_is_missed_among_extremes(
        boxes in prop::collection::vec((any_point(), any_size()), 0..60),
        origin in any_point(),
        target in any_point(),
        offset in any_point(),
    ) {
        let bounds: Vec<Bounds> = boxes.iter().map(|&(at, size)| Bounds::of([at + offset, at + offset + size])).collect();
        prop_assume!(target != origin);
        nothing_missed(&bounds, origin + offset, (target - origin).normalize(), f64::INFINITY)?;
        for axis in [DVec3::X, DVec3::NEG_Y, DVec3::Z] {
            nothing_missed(&bounds, origin + offset, axis, f64::INFINITY)?;
        }
    }
}

fn nothing_missed(bounds: &[Bounds], origin: DVec3, direction: DVec3, limit: f64) -> Result<(), TestCaseError> {
    let (bvh, order) = Bvh::build(bounds);
    check(bounds, &bvh, &order);
    let visited = visited(&bvh, &order, origin, direction, limit);
    prop_assert!(visited.windows(2).all(|pair| pair[0] < pair[1]));
    for (item, bounds) in (0..).zip(bounds) {
        if meets(bounds, origin, direction).is_some_and(|near| near <= limit) {
            prop_assert!(visited.binary_search(&item).is_ok(), "{item}: {bounds:?}");
        }
    }
    Ok(())
}

#[test]
fn equal_and_growing_boxes_stay_shallow() {
    for bounds in [
        vec![Bounds { low: DVec3::ZERO, high: DVec3::ONE }; 5000],
        vec![Bounds { low: DVec3::ONE, high: DVec3::ONE }; 5000],
        (0..1000).map(|n| Bounds::of([DVec3::ZERO, DVec3::X * 1.05_f64.powi(n)])).collect(),
        (0..3000).map(|n| Bounds::of([DVec3::X * 1.01_f64.powi(-n), DVec3::X * 1.01_f64.powi(-n)])).collect(),
        (0..5000).map(|n| Bounds::of([DVec3::splat(f64::from(n).powi(6))])).collect(),
        (0..9000).map(|n| Bounds::of([DVec3::splat(-f64::from(n)), DVec3::splat(f64::from(n))])).collect(),
    ] {
        let (bvh, order) = Bvh::build(&bounds);
        check(&bounds, &bvh, &order);
        visited(&bvh, &order, DVec3::new(0.5, 0.5, -1.0), DVec3::Z, f64::INFINITY);
    }
    // far beyond single precision, which no checked scene is, there is still an end
    let bounds: Vec<Bounds> = (0..1000).map(|n| Bounds::of([DVec3::ZERO, DVec3::X * 1.7_f64.powi(n)])).collect();
    let (bvh, order) = Bvh::build(&bounds);
    assert!(visited(&bvh, &order, DVec3::new(0.5, 0.5, -1.0), DVec3::Z, f64::INFINITY).len() >= 1000);
}

/// What a ray cannot meet costs little: of a thousand boxes in a row a ray across visits a few.
#[test]
fn most_boxes_are_never_looked_at() {
    let bounds: Vec<Bounds> =
        (0..1000).map(|n| Bounds::of([DVec3::X * f64::from(n), DVec3::new(f64::from(n) + 0.5, 1.0, 1.0)])).collect();
    let (bvh, order) = Bvh::build(&bounds);
    let across = visited(&bvh, &order, DVec3::new(500.25, 0.5, -9.0), DVec3::Z, f64::INFINITY);
    assert!(across.contains(&500) && across.len() <= 8, "{across:?}");
    assert!(visited(&bvh, &order, DVec3::new(500.25, 0.5, -9.0), DVec3::Z, 8.0).is_empty(), "beyond the limit");
    assert!(visited(&bvh, &order, DVec3::new(500.25, 0.5, 9.0), DVec3::Z, f64::INFINITY).is_empty(), "behind");
}

/// A rough square of `2·n²` facets; every third quadrangle is left out, so that not all facets go by twos.
fn field(n: u32) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let rough = |x: u32| f64::from(x.wrapping_mul(0x9e37_79b9) >> 16) / 65536.0;
    let position = |place: u32| {
        let (i, j) = (place % (n + 1), place / (n + 1));
        DVec3::new(f64::from(i), 3.0 * (0.1 * f64::from(i + j)).sin() + rough(place), f64::from(j))
    };
    let facets = (0..n * n).flat_map(|cell| {
        let a = cell / n * (n + 1) + cell % n;
        [[a, a + n + 1, a + 1], [a + 1, a + n + 1, a + n + 2]].into_iter().skip(usize::from(cell % 3 == 0))
    });
    ((0..(n + 1) * (n + 1)).map(position).collect(), facets.collect())
}

/// Facets are each in one block, and within the box of its leaf.
fn check_blocks(positions: &[DVec3], facets: &[[u32; 3]]) -> (Bvh, Vec<Block>) {
    let (bvh, blocks) = Bvh::over(&Triangles { positions, facets });
    // the blocks in the place of items
    let corners = |facet: u32| facets[facet as usize].map(|vertex| positions[vertex as usize]);
    let bounds: Vec<Bounds> = blocks.iter().map(|block| Bounds::of(block.numbers().flat_map(corners))).collect();
    check(&bounds, &bvh, &(0..blocks.len() as u32).collect::<Vec<_>>());
    let mut numbers: Vec<u32> = blocks.iter().flat_map(|block| block.numbers()).collect();
    numbers.sort_unstable();
    assert_eq!(numbers, (0..facets.len() as u32).collect::<Vec<_>>());
    for block in &blocks {
        for lane in 0..Block::FACETS {
            let facet = block.facets[lane];
            let expected = if facet == u32::MAX {
                [[f32::NAN; 3]; 3]
            } else {
                corners(facet).map(|corner| (corner - bvh.origin()).to_array().map(|x| x as f32))
            };
            let found = [0, 1, 2].map(|corner| [0, 1, 2].map(|axis| block.corners[corner][axis][lane]));
            assert_eq!(found.map(|corner| corner.map(f32::to_bits)), expected.map(|corner| corner.map(f32::to_bits)));
        }
    }
    (bvh, blocks)
}

#[test]
fn blocks_hold_each_facet_once() {
    let (positions, facets) = field(60);
    for count in [0, 1, 2, 3, 4, 5, 7, 8, 9, 31, 33, 100, facets.len()] {
        check_blocks(&positions, &facets[..count]);
    }
}

/// Facets of 10⁹ beside those of 10⁻⁹, and many on one place.
#[test]
fn blocks_hold_facets_of_all_sizes() {
    let mut positions: Vec<DVec3> = Vec::new();
    for n in 0..3000_u32 {
        let size = 10.0_f64.powi(n as i32 % 19 - 9);
        let at = DVec3::new(f64::from(n % 7), f64::from(n % 11), f64::from(n % 13)) * size;
        positions.extend([at, at + DVec3::X * size, at + DVec3::Y * size]);
    }
    positions.extend([DVec3::ONE; 3 * 500]);
    let facets: Vec<[u32; 3]> = (0..3500).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]).collect();
    check_blocks(&positions, &facets);
    // numbers that are none have no place, and do no harm
    positions[17] = DVec3::NAN;
    positions[44] = DVec3::INFINITY;
    positions[79].x = -1e300;
    let (_, blocks) = Bvh::over(&Triangles { positions: &positions, facets: &facets });
    assert_eq!(blocks.iter().flat_map(|block| block.numbers()).count(), facets.len());
}

/// So many that all threads work on them: whatever their number, the tree is the same.
#[test]
fn the_number_of_threads_changes_nothing() {
    let (positions, facets) = field(420);
    let built = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let (bvh, blocks) = pool.install(|| Bvh::over(&Triangles { positions: &positions, facets: &facets }));
        let nodes: Vec<_> = bvh.nodes().iter().map(|node| (node.low, node.high, node.children)).collect();
        (nodes, blocks.iter().map(|block| block.facets).collect::<Vec<_>>())
    };
    let one = built(1);
    assert!(facets.len() > 4 << 16, "enough for sets to be cut together");
    for threads in [2, 3, 8] {
        assert!(built(threads) == one, "{threads} threads");
    }
}

/// A guard of quality and size: what a ray meets on average, and bytes a facet.
#[test]
fn hierarchies_are_good_and_small() {
    for (n, most) in [(10, 4.4), (100, 10.8), (300, 12.0)] {
        let (positions, facets) = field(n);
        let (bvh, blocks) = check_blocks(&positions, &facets);
        assert!(bvh.cost() < most, "{n}: cost {}", bvh.cost());
        let bytes = (size_of_val(bvh.nodes()) + size_of_val(&blocks[..])) as f64 / facets.len() as f64;
        assert!(bytes < 60.0, "{n}: {bytes} bytes a facet");
    }
}
