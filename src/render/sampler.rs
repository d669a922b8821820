//! Samples of the picture: radiances of camera rays through points of the picture.

use super::antialias::rgb_and_transparency;
use super::pixel_area::Pixel;
use super::prepare::FrameCamera;
use crate::camera::Lens;
use crate::color::Rgb;
use crate::math::DVec2;
use crate::math::packet::PACKET;
use crate::transport::{CameraSample, FrameContext, Radiance, RadiositySample, Random, RayCounts, Tracer};
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

/// Consecutive samples that wait until a packet is full.
#[derive(Default)]
struct WaitingSamples {
    /// Index of the first sample.
    first: usize,
    samples: SmallVec<[CameraSample; PACKET]>,
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
        let window = view.window_of_unperturbed_rays();
        let sample = |SamplePoint { x_pixels, y_pixels, pixel, sample }| {
            let ray = match window {
                Some(window) => window.ray_at_pixel_position(x_pixels, y_pixels),
                None => view.ray_at_pixel_position(x_pixels, y_pixels)?,
            };
            Some(CameraSample { ray, pixel, sample })
        };
        self.take_samples(points.into_iter().map(sample), |index, radiance| {
            visit(index, rgb_and_transparency(radiance));
        });
    }

    /// Takes samples through points of the picture and the points of the lens beside them, which are in [0, 1)², and calls
    /// `visit` with the radiance of each, in order. Samples are left out after the render was cancelled.
    pub fn lens_samples(
        &mut self,
        points: impl Iterator<Item = (SamplePoint, DVec2)>,
        lens: &Lens,
        mut visit: impl FnMut(&Radiance),
    ) {
        let FrameCamera { view, axes, .. } = self.camera;
        let sample = |(point, unit_square_point): (SamplePoint, DVec2)| {
            let SamplePoint { x_pixels, y_pixels, pixel, sample } = point;
            let ray = view.ray_at_pixel_position(x_pixels, y_pixels)?;
            Some(CameraSample { ray: lens.ray_through_lens(&ray, unit_square_point, axes), pixel, sample })
        };
        self.take_samples(points.map(sample), |_, radiance| visit(radiance));
    }

    /// Takes samples, and calls `visit` with the index and the radiance of each, in order; `None` for a sample without a camera
    /// ray.
    fn take_samples(
        &mut self,
        samples: impl Iterator<Item = Option<CameraSample>>,
        mut visit: impl FnMut(usize, &Radiance),
    ) {
        let mut waiting = WaitingSamples::default();
        for (index, sample) in samples.enumerate() {
            match sample {
                Some(sample) => {
                    waiting.samples.push(sample);
                    if waiting.samples.len() == PACKET {
                        self.take_waiting_samples(&mut waiting, index + 1, &mut visit);
                    }
                }
                None => {
                    self.take_waiting_samples(&mut waiting, index + 1, &mut visit);
                    visit(index, &Radiance::NO_RAY);
                }
            }
        }
        self.take_waiting_samples(&mut waiting, 0, &mut visit);
    }

    /// Takes the samples that wait, and begins a new list of them at the index `next`.
    fn take_waiting_samples(
        &mut self,
        waiting: &mut WaitingSamples,
        next: usize,
        visit: &mut impl FnMut(usize, &Radiance),
    ) {
        if !self.tracer.poll_is_stopped() {
            let mut radiances = [Radiance::NO_RAY; PACKET];
            self.tracer.camera_radiances(&waiting.samples, &mut radiances[..waiting.samples.len()]);
            for (i, radiance) in radiances.iter().enumerate().take(waiting.samples.len()) {
                visit(waiting.first + i, radiance);
            }
        }
        waiting.samples.clear();
        waiting.first = next;
    }
}
