//! All integration tests, as one program: wgpu is linked once.

mod support;

mod accuracy;
mod cli;
mod exactness;
mod meshes;
mod methods;
mod oracle;
mod orders;
mod pictures;
mod schedules;
mod shaders;
mod structure;
mod written_media;
