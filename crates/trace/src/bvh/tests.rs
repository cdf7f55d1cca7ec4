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
