//! The CSV input and output of `bentray trace`.

/// The columns of results.
pub const HEADER: &str = "ray,status,x,y,z,vx,vy,vz,tau,segments,steps,rejected,object";
/// The columns of paths.
pub const PATH_HEADER: &str = "ray,index,x,y,z,vx,vy,vz,tau";

/// The rows of a table, by column.
pub struct Rows(pub Vec<Vec<String>>);

impl Rows {
    /// Reads a table, which must have this header.
    #[track_caller]
    pub fn of(table: &str, header: &str) -> Self {
        let mut lines = table.lines();
        assert_eq!(lines.next(), Some(header));
        let columns = header.split(',').count();
        let rows: Vec<Vec<String>> = lines.map(|line| line.split(',').map(str::to_owned).collect()).collect();
        assert!(rows.iter().all(|row| row.len() == columns), "{table}");
        Self(rows)
    }

    /// Returns the fields of one column of results.
    pub fn column(&self, name: &str) -> Vec<&str> {
        let at = HEADER.split(',').position(|column| column == name).unwrap();
        self.0.iter().map(|row| row[at].as_str()).collect()
    }

    /// Returns the position, velocity and tau of a row, which follow two other columns in both kinds of table.
    pub fn numbers(&self, row: usize) -> [f32; 7] {
        let numbers = self.0[row][2..9].iter().map(|text| text.parse().unwrap());
        numbers.collect::<Vec<f32>>().try_into().unwrap()
    }

    /// Returns the distance from a row's position to a point.
    pub fn distance(&self, row: usize, from: [f64; 3]) -> f64 {
        let numbers = self.numbers(row);
        let squares = (0..3).map(|k| (f64::from(numbers[k]) - from[k]).powi(2));
        squares.sum::<f64>().sqrt()
    }
}

/// Returns the text of a file with these rays.
pub fn table(rays: &[[f64; 6]]) -> String {
    let row = |ray: &[f64; 6]| ray.map(|x| x.to_string()).join(",") + "\n";
    "x,y,z,vx,vy,vz\n".to_owned() + &rays.iter().map(row).collect::<String>()
}
