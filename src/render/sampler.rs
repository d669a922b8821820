//! Samples of the picture: radiances of camera rays through points of the picture.

use super::prepare::FrameCamera;
use crate::camera::Lens;
use crate::color::Rgb;
use crate::math::DVec2;
use crate::transport::{FrameContext, Purpose, Radiance, RadiositySample, RandomSequence, RayCounts, Tracer};

/// Sampler that takes samples one by one, on one thread. Points are in pixels from the picture's top left corner.
pub(super) struct Sampler<'w> {
    camera: &'w FrameCamera,
    tracer: Tracer<'w>,
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

    /// Returns random numbers of the current sample.
    pub fn random(&mut self, purpose: Purpose) -> RandomSequence {
        self.tracer.random.sequence(purpose)
    }

    /// Returns random numbers that all samples of the current pixel share.
    pub fn pixel_random(&self, purpose: Purpose) -> RandomSequence {
        self.tracer.random.pixel_sequence(purpose)
    }

    /// Removes the samples of radiosity that were collected since the last call, and returns them.
    pub fn take_radiosity_samples(&mut self) -> Vec<RadiositySample> {
        self.tracer.take_radiosity_samples()
    }

    /// True if the render was cancelled, so that later samples are invalid.
    pub fn is_stopped(&self) -> bool {
        self.tracer.is_stopped()
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

    /// Returns the radiance through a point of the picture and a point of the lens, which is in [0, 1)².
    pub fn lens_sample(&mut self, x_pixels: f64, y_pixels: f64, lens: &Lens, unit_square_point: DVec2) -> Radiance {
        let ray = self
            .camera
            .view
            .ray_at_pixel_position(x_pixels, y_pixels)
            .map(|ray| lens.ray_through_lens(&ray, unit_square_point, &self.camera.axes));
        ray.map_or(Radiance::NO_RAY, |ray| self.tracer.camera_radiance(ray))
    }
}
