//! Light along one ray: intersection, segment, direct light, scattering. Nothing here depends on pixels.
//!
//! [`Tracer`] estimates the radiance that arrives at a ray's origin. Its loop (`radiance`) works on a queue of ray states; each step
//! is one file: `segment` (air and attenuation between two surfaces), `shading_point` (materials at a hit), `direct_light` with
//! `visibility` and `area_light` (light from light sources), `subsurface` with `dipole` (light through translucent solids),
//! `photons` (light by way of targets), `radiosity` (diffuse light from other surfaces), `scatter` with `reflect`, `interface`
//! and `dispersion` (the rays that continue from the surface). Camera rays take these steps in packets of eight as far as their
//! surfaces are opaque (`packet`), with the same results.

mod area_light;
mod context;
mod dipole;
mod direct_light;
mod dispersion;
mod interface;
mod media;
mod media_intervals;
mod packet;
mod photons;
mod radiance;
mod radiosity;
mod random;
mod ray_state;
mod reflect;
mod scatter;
mod segment;
mod shading_point;
mod single_layer;
mod subsurface;
mod tracer;
mod visibility;

pub use context::{CameraOrigin, FrameContext, Quality};
pub use packet::SamplePacket;
pub use photons::{PhotonPass, Photons};
pub use radiance::Radiance;
pub use radiosity::{RadiosityPass, RadiosityState, Sample as RadiositySample};
pub use random::{Purpose, Random, RandomSequence};
pub use tracer::{RayCounts, Tracer};
