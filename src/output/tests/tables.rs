//! Tests of input and output tables.

use std::fs;
use std::io::Read;

use super::folder;
use crate::output::csv::read_rays;
use crate::output::table::{LightRow, Table};
use crate::render::{PathPoint, Status, Traced};

/// Reads a file of rays with this text, and returns an error as its message without the path.
fn rays(text: &str) -> Result<Vec<[f64; 6]>, String> {
    let folder = folder();
    let path = folder.path().join("rays.csv");
    fs::write(&path, text).unwrap();
    read_rays(&path, true).map_err(|error| {
        let message = error.to_string();
        let prefix = format!("{}: ", path.display());
        message.strip_prefix(&prefix).unwrap().to_owned()
    })
}

#[test]
fn reads_rays_in_any_order_of_columns() {
    let expected = [[1.0, 2.0, 3.0, 4.0, 5.0, 6.0], [-0.5, 1e-3, 0.0, 1.0, 0.0, 0.0]];
    let plain = "x,y,z,vx,vy,vz\n1,2,3,4,5,6\n-.5,1e-3,0,1,0,0";
    assert_eq!(rays(plain).unwrap(), expected);
    let odd = "\u{feff}\r\n vx, vy ,vz,z,y,x \r\n4,5,6,3,2,1\r\n\r\n1,0,0, 0 ,0.001,-0.5\r\n";
    assert_eq!(rays(odd).unwrap(), expected);
    let noted = format!("# at rest\n{}\n  # the end", plain.replace("\n1", "\n#7,8\n1"));
    assert_eq!(rays(&noted).unwrap(), expected);
}

#[test]
fn says_what_is_wrong_and_where() {
    let header = "x,y,z,vx,vy,vz\n";
    for (text, parts) in [
        (String::new(), vec!["line 1", "empty", "x,y,z,vx,vy,vz"]),
        (header.into(), vec!["line 1", "no rays"]),
        ("x,y,z,vx,vy,w\n".into(), vec!["line 1", "column 6", "`w`", "vz"]),
        ("x,y,z,vx,vy,x\n".into(), vec!["line 1", "column 6", "twice"]),
        ("x,y,z,vx,vy\n".into(), vec!["line 1", "missing column `vz`"]),
        ("1,2,3,4,5,6\n".into(), vec!["line 1", "column 1", "`1`"]),
        (format!("{header}1,2,3\n"), vec!["line 2", "3 fields", "6"]),
        (format!("{header}1,2,3,4,5,6,7\n"), vec!["line 2", "7 fields"]),
        (format!("{header}\n1,2,abc,4,5,6\n"), vec!["line 3", "column 3 (z)", "`abc`"]),
        (format!("{header}1,2,,4,5,6\n"), vec!["column 3 (z)", "``"]),
        (format!("{header}1,2,3,nan,5,6\n"), vec!["column 4 (vx)", "`nan`", "finite"]),
        (format!("{header}1,2,3,4,5,1e999\n"), vec!["column 6 (vz)", "`1e999`"]),
    ] {
        let message = rays(&text).unwrap_err();
        for part in parts {
            assert!(message.contains(part), "{text:?}: {message}");
        }
    }
    let missing = folder().path().join("none.csv");
    assert!(read_rays(&missing, true).unwrap_err().to_string().contains("none.csv"));
}

#[test]
fn rows_are_written_to_the_last_bit() {
    let folder = folder();
    let path = folder.path().join("out.csv");
    let mut table = Table::create::<(usize, &Traced)>(&path).unwrap();
    let end = Traced {
        status: Status::Hit,
        x: [f64::from(0.1_f32 + 0.2_f32), 0.1 + 0.2, 1e30],
        v: [1.0, f64::from(1e-45_f32), f64::NAN],
        tau: 2.5,
        segments: f64::INFINITY,
        steps: 10,
        rejected: 1,
        object: Some(3),
    };
    table.write(&(7, &end)).unwrap();
    table.finish().unwrap();
    assert_eq!(
        fs::read_to_string(&path).unwrap(),
        "ray,status,x,y,z,vx,vy,vz,tau,segments,steps,rejected,object\n\
         7,hit,0.3,0.30000000000000004,1e30,1.0,1e-45,NaN,2.5,inf,10,1,3\n"
    );

    let mut table = Table::create::<(usize, usize, &PathPoint)>(&path).unwrap();
    table.write(&(0, 3, &PathPoint { x: [1.0, 2.0, 3.0], v: [4.0, 5.0, 6.0], tau: 0.5 })).unwrap();
    table.finish().unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), "ray,index,x,y,z,vx,vy,vz,tau\n0,3,1.0,2.0,3.0,4.0,5.0,6.0,0.5\n");
}

#[test]
fn columns_are_arrays_of_their_kind() {
    let folder = folder();
    let path = folder.path().join("a.npz");
    let mut table = Table::create::<LightRow>(&path).unwrap();
    let none = LightRow { place: 3, light: 0, status: "none", leaves: None, arrives: None, spread: None };
    table.write(&none).unwrap();
    table.write(&LightRow { status: "shadow", spread: Some(0.1), ..none }).unwrap();
    table.finish().unwrap();
    let mut archive = zip::ZipArchive::new(fs::File::open(path).unwrap()).unwrap();
    for (name, kind, values) in [
        ("place", "<i8", [3_i64.to_le_bytes(), 3_i64.to_le_bytes()].concat()),
        ("spread", "<f8", [f64::NAN.to_le_bytes(), 0.1_f64.to_le_bytes()].concat()),
        ("status", "<U6", "none\0\0shadow".chars().flat_map(|c| u32::from(c).to_le_bytes()).collect()),
    ] {
        let mut bytes = Vec::new();
        archive.by_name(&format!("{name}.npy")).unwrap().read_to_end(&mut bytes).unwrap();
        let (head, own) = bytes.split_at(bytes.len() - values.len());
        assert_eq!(own, values, "{name}");
        assert_eq!(head.len() % 64, 0);
        let words = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': (2,), }}");
        assert_eq!(String::from_utf8_lossy(&head[10..]).trim_end(), words);
    }
}
