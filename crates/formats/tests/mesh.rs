//! Mesh files of every format: what they give, what is refused and in which line, and that nothing makes a reader panic
//! or take more memory than its file gives it a right to.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that fails says so by panicking")]

mod meshes_by_hand;

use glam::DVec3;
use lancer_formats::Describe;
use lancer_formats::mesh::{self, FilesBeside, MeshFault};
use lancer_scene::{Enclosure, Mesh, MeshGeometry, Rgb};
use lancer_words::Lang;
use meshes_by_hand::*;
use std::sync::Arc;

// OBJ

#[test]
fn an_obj_cube_of_quads_is_closed_and_has_the_parts_of_its_library() {
    let file = read("cube.obj", by_hand("cube.obj"));
    assert_eq!(warnings(&file), [""; 0]);
    let geometry = &file.geometry;
    assert_eq!((geometry.positions.len(), geometry.facets.len()), (8, 12));
    assert_eq!(geometry.check(), Ok(()));
    assert_eq!(geometry.enclosure(), Enclosure::Volume { inverted: false });
    assert!((area(geometry) - 24.0).abs() < 1e-12);
    assert_eq!(parts(geometry), [(0, 6), (6, 6)]);

    let red = surface(&geometry.parts[0].material);
    assert_eq!((red.ka, red.kd), (Rgb::new(0.1, 0.0, 0.0), Rgb::new(0.8, 0.1, 0.1)));
    assert_eq!((red.ks, red.kr), (Rgb::splat(0.5), Rgb::splat(0.5)));
    assert_eq!((red.shininess, red.kt, red.index), (Rgb::splat(40.0), Rgb::BLACK, Rgb::WHITE));

    let glass = surface(&geometry.parts[1].material);
    assert_eq!((glass.kd, glass.kt), (Rgb::splat(0.6 * 0.25), Rgb::new(0.75, 0.75, 0.375)));
    assert_eq!((glass.index, glass.kr), (Rgb::splat(1.5), Rgb::BLACK));
    assert!((glass.ka.r - 0.05).abs() < 1e-15, "a third of what is left of Kd");
}

#[test]
fn an_object_with_a_material_of_its_own_shares_the_geometry_without_parts() {
    let file = read("cube.obj", by_hand("cube.obj"));
    let plain = file.without_materials();
    assert!(plain.parts.is_empty() && plain.facets == file.geometry.facets);
    assert!(Arc::ptr_eq(&plain, &file.clone().without_materials()));
    let simple = read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3");
    assert!(Arc::ptr_eq(&simple.geometry, &simple.without_materials()));
}

#[test]
fn an_obj_crease_splits_a_vertex_and_equal_normals_do_not() {
    let file = read("normals.obj", by_hand("normals.obj"));
    let geometry = &file.geometry;
    assert_eq!(geometry.facets, [[0, 1, 2], [4, 5, 3]]);
    assert_eq!(geometry.positions[4], geometry.positions[1]);
    assert_eq!(geometry.positions[5], geometry.positions[0]);
    let (up, front) = (DVec3::Z, DVec3::NEG_Y);
    assert_eq!(geometry.normals, [up, up, up, front, front, front]);
    assert_eq!(geometry.check(), Ok(()));
}

#[test]
fn obj_normals_that_are_incomplete_or_no_directions_are_left_out() {
    let vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for rest in ["vn 0 0 1\nf 1//1 2//1 3\n", "vn 0 0 0\nf 1//1 2//1 3//1\n", "vn nan 0 1\nf 1//1 2//1 3//1\n"] {
        let file = read("a.obj", format!("{vertices}{rest}"));
        assert!(file.geometry.normals.is_empty());
        let expected = "mesh file `a.obj`: its normals are not used: some are missing or have no direction";
        assert_eq!(warnings(&file), [expected]);
        assert_eq!(file.warnings[0].help(Lang::English).unwrap(), "smooth normals are computed from the facets");
    }
}

#[test]
fn an_obj_polygon_with_a_dent_is_cut_inside_it() {
    let file = read("a.obj", "v 0 0 0\r\nv 4 2 0\r\nv 0 4 0\r\nv 1 2 0\r\nf 1 2 3 4\r\n");
    assert_eq!(file.geometry.facets.len(), 2);
    assert!((area(&file.geometry) - 6.0).abs() < 1e-12);
}

#[test]
fn an_obj_file_says_what_is_wrong_and_where() {
    let vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let said = |rest: &str| message("m/a.obj", format!("{vertices}{rest}\n"));
    let in_4 = |text: &str| format!("mesh file `m/a.obj`, line 4: {text}");
    assert_eq!(said("f 1 2 4"), in_4("a facet names vertex 4, but there are 3 vertices"));
    assert_eq!(said("f 1 2 0"), in_4("a facet names vertex 0, but there are 3 vertices"));
    assert_eq!(said("f 1 2 -4"), in_4("a facet names vertex -4, but there are 3 vertices"));
    assert_eq!(said("f 1//1 2 3"), in_4("a facet names normal 1, but there are 0 normals"));
    assert_eq!(said("f 1 2"), in_4("a facet needs three corners, not 2"));
    assert_eq!(said("f 1 2 three"), in_4("a number is due, not `three`"));
    assert_eq!(said("f 1 2 99999999999999999999"), in_4("a number is due, not `99999999999999999999`"));
    assert_eq!(said("v 1 2"), in_4("`v` needs three numbers"));
    assert_eq!(said("v 1 2 0,5"), in_4("a number is due, not `0,5`"));
    assert_eq!(said("v 1 nan 3"), in_4("the coordinate NaN is not allowed"));
    assert_eq!(said("v 1 2e9 3"), in_4("the coordinate 2e9 is not allowed"));
    assert_eq!(said("\n\nv 1 inf 3"), "mesh file `m/a.obj`, line 6: the coordinate inf is not allowed");
    assert_eq!(message("a.obj", vertices), "mesh file `a.obj`: there is not one facet");
    assert_eq!(message("a.obj", ""), "mesh file `a.obj`: there is not one facet");
    assert_eq!(
        refused("a.obj", "v 0 0 1e10").help(Lang::English).unwrap(),
        "coordinates are finite and lie within ±1e9"
    );
    assert_eq!(
        refused("a.obj", "f 1 2 3").message(Lang::French),
        "fichier de maillage « a.obj », ligne 1 : une facette nomme le sommet 1, mais il y a 0 sommets"
    );
}

#[test]
fn a_line_behind_a_continued_one_has_its_own_number() {
    let text = "v 0 0 0\nv 1 \\\n 0 \\\n 0\nv 0 1 0\nf 1 2 9\n";
    assert_eq!(message("a.obj", text), "mesh file `a.obj`, line 6: a facet names vertex 9, but there are 3 vertices");
}

#[test]
fn a_polygon_of_too_many_corners_is_refused() {
    let mut text = String::from("v 0 0 0\nf");
    text.push_str(&" 1".repeat(5000));
    let problem = refused("a.obj", text);
    assert_eq!(problem.fault, MeshFault::TooManyCorners { corners: 5000, most: 4096 });
}

#[test]
fn what_is_odd_about_a_library_is_a_warning() {
    let facet = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let missing = read("m/a.obj", format!("mtllib lost.mtl\n{facet}usemtl red\nf 1 2 3\nusemtl red\nf 1 2 3\n"));
    assert!(missing.geometry.parts.is_empty());
    assert_eq!(
        warnings(&missing),
        [
            "mesh file `m/lost.mtl`: there is no such file",
            "mesh file `m/a.obj`, line 5: no library defines the material `red`",
        ]
    );

    struct Library;
    impl FilesBeside for Library {
        fn read(&mut self, path: &str) -> Result<Vec<u8>, MeshFault> {
            assert!(["two words.mtl", "b.mtl", "a.mtl b.mtl"].contains(&path), "{path}");
            match path {
                "a.mtl b.mtl" => Err(MeshFault::Missing),
                _ => {
                    Ok(b"newmtl m\nKd 2 0.5 0.5\nNs many\nd -halo 0.5\nmap_Kd a.png\nmap_Ka b.png\nNi -1\nKs\n".into())
                }
            }
        }
    }
    let text = format!("mtllib two words.mtl\n{facet}usemtl m\nf 1 2 3\n");
    let file = mesh::read("a.obj", text.as_bytes(), &mut Library).unwrap();
    let material = surface(&file.geometry.parts[0].material);
    assert_eq!((material.kd, material.kt), (Rgb::new(0.5, 0.25, 0.25), Rgb::splat(0.5)));
    assert_eq!((material.shininess, material.index), (Rgb::splat(30.0), Rgb::splat(0.001)));
    assert_eq!(material.check(), Ok(()));
    assert_eq!(
        warnings(&file),
        [
            "mesh file `two words.mtl`, line 2: `Kd` was out of range and is brought into it",
            "mesh file `two words.mtl`, line 3: a number is due, not `many`",
            "mesh file `two words.mtl`, line 5: its textures are not used",
            "mesh file `two words.mtl`, line 7: `Ni` was out of range and is brought into it",
            "mesh file `two words.mtl`, line 8: `Ks` needs three numbers",
        ]
    );
}

#[test]
fn an_obj_file_may_name_several_libraries_in_a_line() {
    struct Libraries;
    impl FilesBeside for Libraries {
        fn read(&mut self, path: &str) -> Result<Vec<u8>, MeshFault> {
            match path {
                "a.mtl" => Ok(b"newmtl one".into()),
                "b.mtl" => Ok(b"newmtl two".into()),
                _ => Err(MeshFault::Missing),
            }
        }
    }
    let text = "mtllib a.mtl b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl one\nf 1 2 3\nusemtl two\nf 1 2 3\nusemtl two\nf 3 2 1\n";
    let file = mesh::read("x/a.obj", text.as_bytes(), &mut Libraries).unwrap();
    assert_eq!((warnings(&file).len(), parts(&file.geometry)), (0, vec![(0, 1), (1, 2)]));
}

// PLY

#[test]
fn a_ply_text_with_other_elements_and_properties() {
    let file = read("dart.ply", by_hand("dart.ply"));
    assert_eq!(positions(&file.geometry), [[0.0, 0.0, 5.0], [4.0, 2.0, 5.0], [0.0, 4.0, 5.0], [1.0, 2.0, 5.0]]);
    assert_eq!(file.geometry.facets.len(), 2);
    assert!((area(&file.geometry) - 6.0).abs() < 1e-12);
}

/// A binary PLY of a tetrahedron with normals, in either order of bytes.
fn binary_ply(big: bool) -> Vec<u8> {
    let order = if big { "big" } else { "little" };
    let mut file = format!(
        "ply\nformat binary_{order}_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
         property double z\nproperty short nx\nproperty char ny\nproperty int nz\nelement face 4\n\
         property list uchar ushort vertex_indices\nproperty uint flags\nend_header\n"
    )
    .into_bytes();
    let mut put = |bytes: &[u8]| {
        let bytes = bytes.iter().copied();
        if big { file.extend(bytes.rev()) } else { file.extend(bytes) }
    };
    for [x, y, z] in [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.1, 0.0]] {
        put(&(x as f32).to_le_bytes());
        put(&(y as f32).to_le_bytes());
        put(&f64::to_le_bytes(z));
        put(&(-300_i16).to_le_bytes());
        put(&(-1_i8).to_le_bytes());
        put(&70_000_i32.to_le_bytes());
    }
    for facet in [[0_u16, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]] {
        put(&[3]);
        facet.iter().for_each(|vertex| put(&vertex.to_le_bytes()));
        put(&u32::MAX.to_le_bytes());
    }
    file
}

#[test]
fn both_binary_ply_forms_hold_the_same() {
    let little = read("a.ply", binary_ply(false)).geometry;
    assert_eq!(little, read("a.ply", binary_ply(true)).geometry);
    assert_eq!(little.positions[3], DVec3::new(0.0, f64::from(0.1_f32), 0.0));
    assert_eq!(little.normals, [DVec3::new(-300.0, -1.0, 70_000.0); 4]);
    assert_eq!(little.facets, [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]);
    assert_eq!(little.enclosure(), Enclosure::Volume { inverted: false });
}

#[test]
fn a_ply_file_says_what_is_wrong_and_where() {
    let header = |body: &str| format!("ply\nformat ascii 1.0\n{body}");
    let xyz = "property float x\nproperty float y\nproperty float z\n";
    let face = "property list uchar int vertex_indices\n";
    let triangle = |vertices: &str, facet: &str| {
        header(&format!("element vertex 3\n{xyz}element face 1\n{face}end_header\n{vertices}\n{facet}\n"))
    };
    let said = |text: String| message("a.ply", text);
    let in_line = |line: usize, text: &str| format!("mesh file `a.ply`, line {line}: {text}");
    let good = "0 0 0\n1 0 0\n0 1 0";
    assert_eq!(read("a.ply", triangle(good, "3 0 1 2")).geometry.facets, [[0, 1, 2]]);
    assert_eq!(said("PLY\n".into()), in_line(1, "`ply` is due, not `PLY`"));
    assert_eq!(said("ply\nformat ascii 1.0".into()), in_line(2, "the file ends where more is due"));
    assert_eq!(said("ply\nend_header\n".into()), in_line(2, "`format` is missing"));
    assert_eq!(
        said("ply\nformat text 1.0\n".into()),
        in_line(2, "the PLY form `text` is not known; known are ascii, binary_little_endian and binary_big_endian")
    );
    assert_eq!(said(header("property int x\n")), in_line(3, "`element` is due, not `property int x`"));
    assert_eq!(said(header("element vertex many\n")), in_line(3, "a number is due, not `many`"));
    assert_eq!(said(header("element vertex 1\nproperty half x\n")), in_line(4, "`type` is due, not `half`"));
    assert_eq!(said(header("hello\n")), in_line(3, "`end_header` is due, not `hello`"));
    let no_z = "element vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n";
    assert_eq!(said(header(no_z)), in_line(7, "`z` is missing"));
    assert_eq!(
        said(header("element face 1\nproperty int x\nend_header\n1\n")),
        in_line(6, "`vertex_indices` is missing")
    );
    assert_eq!(said(triangle(good, "3 0 1 3")), in_line(13, "a facet names vertex 3, but there are 3 vertices"));
    assert_eq!(said(triangle(good, "3 0 1 -1")), in_line(13, "a facet names vertex -1, but there are 3 vertices"));
    assert_eq!(said(triangle(good, "2 0 1")), in_line(13, "a facet needs three corners, not 2"));
    assert_eq!(said(triangle(good, "-3 0 1 2")), in_line(13, "`count` is due, not `-3`"));
    assert_eq!(said(triangle("0 0 0\n1 nan 0\n0 1 0", "3 0 1 2")), in_line(11, "the coordinate NaN is not allowed"));
    assert_eq!(said(triangle("0 0 0\n1 x 0\n0 1 0", "3 0 1 2")), in_line(11, "a number is due, not `x`"));
    assert_eq!(said(triangle(good, "3 0 1")), in_line(14, "the file ends where more is due"));
    assert_eq!(said(header("element vertex 0\nend_header\n")), "mesh file `a.ply`, line 5: `x` is missing");
    let none = header(&format!("element vertex 0\n{xyz}end_header\n"));
    assert_eq!(said(none), "mesh file `a.ply`: there is not one facet");
}

/// A count of a header costs nothing until its values are there.
#[test]
fn hostile_ply_counts_end_at_once() {
    for element in ["vertex", "face", "other"] {
        for form in ["ascii", "binary_little_endian"] {
            for properties in [
                "property float x\nproperty float y\nproperty float z\nproperty list int int vertex_indices\n",
                "property list uint double vertex_index\nproperty float x\nproperty float y\nproperty float z\n",
                "",
            ] {
                let header = format!("ply\nformat {form} 1.0\nelement {element} 18446744073709551615\n{properties}");
                let file = [header.as_bytes(), b"end_header\n\xff\xff\xff\xff 4294967295 1 2 3"].concat();
                assert!(mesh::read("a.ply", &file, &mut Folder).is_err());
            }
        }
    }
}

// STL

#[test]
fn an_stl_text_of_two_solids_is_one_closed_mesh() {
    let geometry = read("a.stl", by_hand("tetrahedron.stl")).geometry;
    assert_eq!(positions(&geometry), [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]);
    assert_eq!(geometry.facets, [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]);
    assert_eq!(geometry.enclosure(), Enclosure::Volume { inverted: false });
}

fn binary_stl(comment: &[u8], geometry: &MeshGeometry) -> Vec<u8> {
    let mut file = comment.to_vec();
    file.resize(80, 0);
    file.extend((geometry.facets.len() as u32).to_le_bytes());
    for facet in &geometry.facets {
        file.extend([0; 12]);
        for vertex in facet {
            let position = geometry.positions[*vertex as usize].to_array();
            position.iter().for_each(|value| file.extend((*value as f32).to_le_bytes()));
        }
        file.extend([0; 2]);
    }
    file
}

#[test]
fn a_binary_stl_is_told_by_its_length_whatever_it_begins_with() {
    let geometry = read("a.stl", by_hand("tetrahedron.stl")).geometry;
    for comment in [&b"binary"[..], b"solid but binary", b""] {
        assert_eq!(read("A.STL", binary_stl(comment, &geometry)).geometry, geometry);
    }
    let with_rest = [binary_stl(b"x", &geometry), vec![0; 7]].concat();
    assert_eq!(read("a.stl", with_rest).geometry, geometry);
}

#[test]
fn an_stl_file_says_what_is_wrong_and_where() {
    let text = String::from_utf8(by_hand("tetrahedron.stl")).unwrap();
    let said = |text: &str| message("a.stl", text);
    let in_line = |line: usize, text: &str| format!("mesh file `a.stl`, line {line}: {text}");
    assert_eq!(said(&text.replacen("outer", "inner", 1)), in_line(3, "`outer` is due, not `inner`"));
    assert_eq!(said(&text.replacen("vertex 1 0 0", "vertex 1 0 x", 1)), in_line(5, "a number is due, not `x`"));
    assert_eq!(
        said(&text.replacen("vertex 1 0 0", "vertex 1 0 1e40", 1)),
        in_line(5, "the coordinate 1e40 is not allowed")
    );
    assert_eq!(said(&text.replacen("vertex 1 0 0", "vertex 1 0", 1)), in_line(6, "a number is due, not `vertex`"));
    assert_eq!(
        said(&text.replacen("endloop", "vertex 0 0 0 endloop", 1)),
        in_line(7, "`endloop` is due, not `vertex`")
    );
    assert_eq!(said("solid x\nendsolid x\n"), "mesh file `a.stl`: there is not one facet");
    assert_eq!(said("solid x\nfacet normal 0 0 1"), in_line(2, "the file ends where more is due"));
    assert_eq!(said("solid x\nendsolid\nmore"), in_line(3, "`solid` is due, not `more`"));
    assert_eq!(said("neither"), "mesh file `a.stl`: the file ends where more is due");
    let geometry = read("a.stl", &text).geometry;
    let mut binary = binary_stl(b"", &geometry);
    binary.pop();
    assert_eq!(refused("a.stl", &binary).fault, MeshFault::EndsEarly);
    binary[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    assert_eq!(refused("a.stl", &binary).fault, MeshFault::EndsEarly);
    let mut far = binary_stl(b"", &geometry);
    far[96..100].copy_from_slice(&f32::INFINITY.to_le_bytes());
    assert_eq!(message("a.stl", &far), "mesh file `a.stl`: the coordinate inf is not allowed");
}

// all formats

#[test]
fn a_name_decides_the_format() {
    let problem = refused("rabbit.blend", "");
    assert_eq!(problem.message(Lang::English), "mesh file `rabbit.blend`: no mesh format has the extension `.blend`");
    assert_eq!(problem.help(Lang::English).unwrap(), "name an OBJ, PLY, STL or glTF file: .obj .ply .stl .gltf .glb");
    assert_eq!(message("rabbit", ""), "mesh file `rabbit`: no mesh format has the extension ``");
    read("CUBE.OBJ", by_hand("cube.obj"));
}

/// Marsaglia's xorshift: the same damage in every run.
fn random(state: &mut u64) -> usize {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    (*state >> 32) as usize
}

#[test]
fn damaged_files_are_read_or_refused() {
    let tetrahedron = read("a.stl", by_hand("tetrahedron.stl")).geometry;
    let files = [
        ("a.obj", by_hand("cube.obj")),
        ("a.obj", by_hand("normals.obj")),
        ("a.ply", by_hand("dart.ply")),
        ("a.ply", binary_ply(false)),
        ("a.ply", binary_ply(true)),
        ("a.stl", by_hand("tetrahedron.stl")),
        ("a.stl", binary_stl(b"solid", &tetrahedron)),
        ("a.gltf", by_hand("two.gltf")),
        ("a.glb", glb(|document| document)),
    ];
    let check = |name: &str, bytes: &[u8]| {
        if let Ok(file) = mesh::read(name, bytes, &mut Folder) {
            assert_eq!(file.geometry.check(), Ok(()), "{name}: {:?}", String::from_utf8_lossy(bytes));
            assert!(!file.geometry.facets.is_empty());
            assert!(file.geometry.parts.iter().all(|part| surface(&part.material).check().is_ok()));
        }
    };
    let mut state = 0x9e37_79b9_7f4a_7c15;
    for (name, whole) in &files {
        for cut in 0..200 {
            check(name, &whole[..whole.len() * cut / 200]);
        }
        for _ in 0..5_000 {
            let mut damaged = whole.clone();
            for _ in 0..1 + random(&mut state) % 4 {
                let at = random(&mut state) % damaged.len();
                match random(&mut state) % 4 {
                    0 => damaged[at] = random(&mut state) as u8,
                    1 => damaged[at] = b"0123456789-. \n{}[],"[random(&mut state) % 19],
                    2 => drop(damaged.remove(at)),
                    _ => {
                        let other = random(&mut state) % damaged.len();
                        damaged.swap(at, other);
                    }
                }
            }
            check(name, &damaged);
        }
    }
}

/// Every binary bit of a material library may be anything: the mesh is read all the same.
#[test]
fn a_damaged_library_never_hurts_its_mesh() {
    struct Damaged(Vec<u8>);
    impl FilesBeside for Damaged {
        fn read(&mut self, _: &str) -> Result<Vec<u8>, MeshFault> {
            Ok(self.0.clone())
        }
    }
    let (cube, library) = (by_hand("cube.obj"), by_hand("cube.mtl"));
    let mut state = 0x2545_f491_4f6c_dd1d;
    for _ in 0..3_000 {
        let mut damaged = library.clone();
        let at = random(&mut state) % damaged.len();
        damaged[at] = random(&mut state) as u8;
        let file = mesh::read("a.obj", &cube, &mut Damaged(damaged)).unwrap();
        assert!(file.geometry.parts.iter().all(|part| surface(&part.material).check().is_ok()));
    }
}

#[test]
fn a_file_mesh_is_a_mesh_of_the_scene() {
    let file = read("cube.obj", by_hand("cube.obj"));
    let mesh = Mesh {
        geometry: Arc::clone(&file.geometry),
        source: Some("cube.obj".into()),
        placement: lancer_scene::Placement::default(),
        smooth: false,
    };
    assert_eq!(lancer_scene::Shape::Mesh(mesh).check(), Ok(()));
}

/// A measurement: `cargo test --release -p lancer-formats --test mesh -- --ignored --nocapture`.
#[test]
#[ignore = "a measurement"]
fn a_million_facets() {
    use std::fmt::Write;
    let side = 708_u32;
    let at = |x: u32, y: u32| y * side + x;
    let height = |x: u32, y: u32| (f64::from(x) * 0.1).sin() * (f64::from(y) * 0.07).cos();
    let mut facets = Vec::new();
    for (x, y) in (0..side - 1).flat_map(|y| (0..side - 1).map(move |x| (x, y))) {
        facets.push([at(x, y), at(x + 1, y), at(x + 1, y + 1)]);
        facets.push([at(x, y), at(x + 1, y + 1), at(x, y + 1)]);
    }
    let corners: Vec<[f64; 3]> =
        (0..side).flat_map(|y| (0..side).map(move |x| [f64::from(x), f64::from(y), height(x, y)])).collect();
    let mut obj = String::new();
    let mut obj_normals = String::new();
    for [x, y, z] in &corners {
        writeln!(obj, "v {x:.6} {y:.6} {z:.6}").unwrap();
        writeln!(obj_normals, "v {x:.6} {y:.6} {z:.6}\nvn {:.4} 0.0 1.0", z * 0.1).unwrap();
    }
    let mut ply = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        corners.len(),
        facets.len()
    )
    .into_bytes();
    let mut ascii = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        corners.len(),
        facets.len()
    );
    for corner in &corners {
        corner.iter().for_each(|value| ply.extend((*value as f32).to_le_bytes()));
        writeln!(ascii, "{} {} {}", corner[0], corner[1], corner[2]).unwrap();
    }
    for facet in &facets {
        let [a, b, c] = facet.map(|vertex| vertex + 1);
        writeln!(obj, "f {a} {b} {c}").unwrap();
        writeln!(obj_normals, "f {a}//{a} {b}//{b} {c}//{c}").unwrap();
        writeln!(ascii, "3 {} {} {}", facet[0], facet[1], facet[2]).unwrap();
        ply.push(3);
        facet.iter().for_each(|vertex| ply.extend(vertex.to_le_bytes()));
    }
    let positions = corners.iter().map(|corner| DVec3::from(*corner)).collect();
    let stl = binary_stl(b"", &MeshGeometry { positions, facets: facets.clone(), ..MeshGeometry::default() });
    for (name, bytes) in [
        ("a.ply", &ply[..]),
        ("ascii.ply", ascii.as_bytes()),
        ("a.obj", obj.as_bytes()),
        ("normals.obj", obj_normals.as_bytes()),
        ("a.stl", &stl),
    ] {
        for _ in 0..3 {
            let start = std::time::Instant::now();
            let file = read(name, bytes);
            println!("{name}: {} bytes, {} facets in {:?}", bytes.len(), file.geometry.facets.len(), start.elapsed());
        }
    }
}
