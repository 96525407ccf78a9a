//! A force center: a point.

use glam::DVec3;

use super::SourceKind;

pub static KIND: SourceKind =
    SourceKind { name: "center", keys: &[], along: |_| Some(DVec3::ZERO), offset: |d, _| d, is_point: true };
