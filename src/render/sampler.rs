//! Samples of the picture: radiances of camera rays through points of the picture.

use super::antialias::rgb_and_transparency;
use super::pixel_area::Pixel;
use super::prepare::FrameCamera;
use crate::camera::{Lens, View};
use crate::color::Rgb;
use crate::math::packet::{Numbers, PACKET, set_lanes};
use crate::math::{DVec2, Lanes};
use crate::transport::{FrameContext, Radiance, RadiositySample, Random, RayCounts, SamplePacket, Tracer};
use smallvec::SmallVec;

/// Sampler that takes samples one by one, on one thread. Points are in pixels from the picture's top left corner.
pub(super) struct Sampler<'w> {
    camera: &'w FrameCamera,
    tracer: Tracer<'w>,
}

/// A point of the picture through which a sample is taken.
#[derive(Clone, Copy)]
pub(super) struct SamplePoint {
    /// Distance from the left edge of the picture, in pixels.
    pub x_pixels: f64,
    /// Distance from the top edge of the picture, in pixels.
    pub y_pixels: f64,
    /// Key of the pixel, for random numbers.
    pub pixel: u64,
    /// Number of the sample in the pixel.
    pub sample: u64,
}

/// Consecutive samples that are taken side by side. (One value for all packets of a picture's part, which is not copied.)
struct PointPacket {
    /// Number of points.
    n: usize,
    x_pixels: Numbers,
    y_pixels: Numbers,
    /// The samples through the points.
    samples: SamplePacket,
}

impl PointPacket {
    fn new() -> Self {
        let zero = Lanes::splat(0.0);
        Self { n: 0, x_pixels: zero, y_pixels: zero, samples: SamplePacket::NONE }
    }

    /// Replaces the samples by those of the next points. False if there are none.
    #[inline(always)]
    fn take_next(&mut self, view: &View, points: &mut impl Iterator<Item = SamplePoint>) -> bool {
        self.n = 0;
        let samples = &mut self.samples;
        for SamplePoint { x_pixels, y_pixels, pixel, sample } in points.take(PACKET) {
            let i = self.n % PACKET;
            (self.x_pixels.0[i], self.y_pixels.0[i]) = (x_pixels, y_pixels);
            (samples.pixel[i], samples.sample[i]) = (pixel, sample);
            self.n += 1;
        }
        samples.existing = view.set_rays_at_pixel_positions(&self.x_pixels, &self.y_pixels, self.n, &mut samples.rays);
        self.n > 0
    }
}

impl<'w> Sampler<'w> {
    pub fn new(
        context: &'w FrameContext<'w>,
        camera: &'w FrameCamera,
        is_cancelled: &'w (dyn Fn() -> bool + Sync),
    ) -> Self {
        Self { camera, tracer: Tracer::new(context, is_cancelled) }
    }

    /// Starts a sample of a pixel: later random numbers are keyed by both.
    pub fn begin_sample(&mut self, pixel_key: u64, sample: u64) {
        self.tracer.begin_sample(pixel_key, sample);
    }

    /// Returns the generator of random numbers.
    pub fn random(&self) -> &Random {
        &self.tracer.random
    }

    /// Removes the samples of radiosity that were collected since the last call, and returns them.
    pub fn take_radiosity_samples(&mut self) -> Vec<RadiositySample> {
        self.tracer.take_radiosity_samples()
    }

    /// True if the render was cancelled, so that later samples are invalid.
    pub fn is_stopped(&self) -> bool {
        self.tracer.is_stopped()
    }

    /// True if many samples together are taken more quickly than few.
    pub fn is_quicker_with_many_points(&self) -> bool {
        self.tracer.lights_packets()
    }

    /// Returns the numbers of rays traced so far.
    pub fn counts(&self) -> &RayCounts {
        &self.tracer.counts
    }

    /// Returns the radiance through a point of the picture, the mean over all rays of a camera with several per point.
    #[inline]
    pub fn sample(&mut self, x_pixels: f64, y_pixels: f64) -> Radiance {
        let view = &self.camera.view;
        let count = view.max_mesh_rays_per_point();
        if count <= 1 {
            return view
                .ray_at_pixel_position(x_pixels, y_pixels)
                .map_or(Radiance::NO_RAY, |ray| self.tracer.camera_radiance(ray));
        }
        let (mut rgb, mut transparency, mut found) = (Rgb::ZERO, 1.0, 0.0);
        for ray in (0..count).filter_map(|number| view.nth_ray_at_pixels(x_pixels, y_pixels, number)) {
            let radiance = self.tracer.camera_radiance(ray);
            (rgb, transparency, found) = (rgb + radiance.rgb, transparency + radiance.transparency, found + 1.0);
        }
        match found == 0.0 {
            true => Radiance::NO_RAY,
            false => Radiance { rgb: rgb / found, transparency: transparency / found },
        }
    }

    /// Takes the sample at a point.
    pub fn sample_at(&mut self, point: &SamplePoint) -> Pixel {
        self.begin_sample(point.pixel, point.sample);
        rgb_and_transparency(&self.sample(point.x_pixels, point.y_pixels))
    }

    /// Takes samples at several points, and calls `visit` with the index of each point and its sample, in order: the same as
    /// [`Self::sample_at`]. Samples are left out after the render was cancelled.
    pub fn samples_at(&mut self, points: impl IntoIterator<Item = SamplePoint>, mut visit: impl FnMut(usize, Pixel)) {
        let view = &self.camera.view;
        if view.max_mesh_rays_per_point() > 1 {
            points.into_iter().enumerate().for_each(|(index, point)| visit(index, self.sample_at(&point)));
            return;
        }
        let (mut points, mut first, mut packet) = (points.into_iter(), 0, PointPacket::new());
        while !self.tracer.poll_is_stopped() && packet.take_next(view, &mut points) {
            let mut radiances = [Radiance::NO_RAY; PACKET];
            self.tracer.camera_radiances(&packet.samples, &mut radiances);
            for (i, radiance) in radiances.iter().enumerate().take(packet.n) {
                visit(first + i, rgb_and_transparency(radiance));
            }
            first += packet.n;
        }
    }

    /// Takes samples through points of the picture and the points of the lens beside them, which are in [0, 1)², and calls
    /// `visit` with the radiance of each, in order. Samples are left out after the render was cancelled.
    pub fn lens_samples(
        &mut self,
        mut points: impl Iterator<Item = (SamplePoint, DVec2)>,
        lens: &Lens,
        mut visit: impl FnMut(&Radiance),
    ) {
        let FrameCamera { view, axes, .. } = self.camera;
        let mut packet = PointPacket::new();
        while !self.tracer.poll_is_stopped() {
            let mut lens_points: SmallVec<[DVec2; PACKET]> = SmallVec::new();
            let mut picture_points = points.by_ref().map(|(point, lens_point)| {
                lens_points.push(lens_point);
                point
            });
            if !packet.take_next(view, &mut picture_points) {
                break;
            }
            let samples = &mut packet.samples;
            for i in set_lanes(samples.existing) {
                samples.rays.set_ray(i, &lens.ray_through_lens(&samples.rays.ray(i), lens_points[i], axes));
            }
            let mut radiances = [Radiance::NO_RAY; PACKET];
            self.tracer.camera_radiances(samples, &mut radiances);
            radiances.iter().take(packet.n).for_each(&mut visit);
        }
    }
}
