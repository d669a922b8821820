//! Preparation of a frame: data that is computed before the picture and only read while the picture is rendered.
//!
//! Photon maps and radiosity belong here: each is a list of passes ([`Preparation::run_pass`]) whose result becomes a part of
//! the [`FrameContext`], so that no ray of the picture can change it.

use super::workers::Workers;
use super::{Cancelled, Options, Watch, radiosity};
use crate::camera::{Lens, LoweredCamera, View};
use crate::math::DVec3;
use crate::scene::{Digest, SaveFile};
use crate::source::Activity;
use crate::transport::{CameraOrigin, FrameContext, PhotonPass, Photons, Quality, Tracer};
use crate::world::World;
use std::io::{self, Write};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The camera of a frame, prepared for a picture of one size.
pub(super) struct FrameCamera {
    pub view: View,
    /// Lens of a camera with focal blur; `None` for a pinhole.
    pub lens: Option<Lens>,
    /// Unit vectors right, up and ahead, in world space.
    pub axes: [DVec3; 3],
}

impl FrameCamera {
    /// Creates the camera of a picture of `width` × `height` pixels.
    pub fn new(camera: &LoweredCamera, width: usize, height: usize) -> Self {
        let (axes, _) = camera.frame.unit_axes_and_lengths();
        Self { view: camera.view(width, height), lens: camera.lens.clone(), axes }
    }
}

/// Name and work items of one pass that prepares a frame, such as the emission of photons.
pub(super) struct Pass<'a, J> {
    /// Name of the pass for displays.
    pub name: &'static str,
    pub jobs: &'a [J],
}

/// Runs the passes that prepare a frame, one after another.
pub(super) struct Preparation<'a> {
    workers: &'a Workers<'a>,
}

impl<'a> Preparation<'a> {
    /// Creates the preparation of a frame on these workers.
    pub fn new(workers: &'a Workers<'a>) -> Self {
        Self { workers }
    }

    /// Runs a pass: returns the results of `work` for all jobs, in the order of the jobs. `work` reads only what earlier
    /// passes have computed.
    pub fn run_pass<J: Sync, T: Send>(
        &self,
        name: &'static str,
        jobs: &[J],
        work: impl Fn(&J) -> Result<T, Cancelled> + Sync,
    ) -> Result<Vec<T>, Cancelled> {
        let (watch, n_done) = (self.workers.watch, AtomicUsize::new(0));
        watch.preparing(name, 0, jobs.len());
        let work = |job: &J| {
            let result = work(job)?;
            watch.preparing(name, n_done.fetch_add(1, Ordering::Relaxed) + 1, jobs.len());
            Ok(result)
        };
        self.workers.map(jobs, work, || ()).0
    }

    /// Runs a pass in batches: passes the results of each batch to `merge`, in the order of the jobs, before the next batch
    /// begins. `batch_size` returns the number of jobs of the next batch, which must not depend on the number of threads.
    pub fn run_pass_in_batches<J: Sync, T: Send, S: Sync>(
        &self,
        pass: &Pass<J>,
        state: &mut S,
        batch_size: impl Fn(&S) -> usize,
        work: impl Fn(&S, &J) -> Result<T, Cancelled> + Sync,
        mut merge: impl FnMut(&mut S, T),
    ) -> Result<(), Cancelled> {
        let (watch, &Pass { name, jobs }) = (self.workers.watch, pass);
        let mut n_done = 0;
        watch.preparing(name, 0, jobs.len());
        while n_done < jobs.len() {
            let end = (n_done + batch_size(state).max(1)).min(jobs.len());
            let shared = &*state;
            let results = self.workers.map(&jobs[n_done..end], |job| work(shared, job), || ()).0?;
            results.into_iter().for_each(|result| merge(state, result));
            n_done = end;
            watch.preparing(name, n_done, jobs.len());
        }
        Ok(())
    }

    /// Saves light to a file, unless the light is incomplete because the render must stop.
    pub fn save_light(
        &self,
        save: &SaveFile,
        write: &dyn Fn(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Cancelled> {
        if self.is_cancelled() {
            return Err(Cancelled);
        }
        self.workers.watch.save_light(save, write);
        Ok(())
    }

    /// True if the render must stop, so that later results are invalid.
    pub fn is_cancelled(&self) -> bool {
        self.workers.is_cancelled()
    }
}

/// Returns the options that determine photons and samples of radiosity, as text for digests.
pub(super) fn preparation_options(options: &Options) -> String {
    let Options { width, height, quality, frame, alpha, .. } = options;
    format!("{width} {height} {quality} {frame} {alpha}")
}

/// Returns the digests of everything that determines the photons and the radiosity samples of a picture.
pub fn photon_and_radiosity_digests(world: &World, options: &Options) -> [Digest; 2] {
    let (scene, options) = (world.scene_digest(), preparation_options(options));
    [world.photon_digest(&scene, &options), world.radiosity_digest(&scene, &options)]
}

/// Computes the photons and radiosity samples of a picture, passes those with a [`SaveFile`] to
/// [`Watch::save_light`](super::Watch::save_light), and drops the rest: the World is unchanged.
///
/// # Errors
/// [`Cancelled`] if `watch` cancels the work.
pub fn compute_and_save_light(world: &World, options: &Options, watch: &dyn Watch) -> Result<(), Cancelled> {
    let camera = FrameCamera::new(&world.eye, options.width, options.height);
    prepare(world, &camera, options, &Workers::new(options.threads, watch)).map(drop)
}

/// Saves the photons of a frame, if the scene names a file for them.
fn save_photons(context: &FrameContext, options: &Options, preparation: &Preparation) -> Result<(), Cancelled> {
    let settings = context.world.photon_map.as_ref();
    let save = settings.and_then(|settings| settings.saved.save.as_ref());
    if let (Some(photons), Some(save)) = (&context.photons, save) {
        preparation.save_light(save, &|out| {
            // (Digests of a large scene take time, and light that took little time is not saved.)
            let scene = context.world.scene_digest();
            let computation = context.world.photon_digest(&scene, &preparation_options(options));
            photons.save([scene, computation], out)
        })?;
    }
    Ok(())
}

/// Computes the data that all rays of a frame share.
pub(super) fn prepare<'w>(
    world: &'w World,
    camera: &FrameCamera,
    options: &Options,
    workers: &Workers,
) -> Result<FrameContext<'w>, Cancelled> {
    let _activity = Activity::begin("while photons or radiosity were prepared");
    let preparation = Preparation::new(workers);
    if preparation.is_cancelled() {
        return Err(Cancelled);
    }
    let origin = CameraOrigin { origin: camera.view.common_origin(), reach: camera.view.max_distance() };
    let quality = Quality::new(options.quality);
    let mut context = FrameContext::new(world, quality, origin, options.frame, options.alpha, options.has_shafts);
    context.photons = Photons::from_scene_file(&context);
    if let Some(pass) = PhotonPass::new(&context).filter(|_| context.photons.is_none()) {
        let is_cancelled = || preparation.is_cancelled();
        let shards = preparation.run_pass("photons", pass.jobs(), |job| {
            Tracer::new(&context, &is_cancelled).shoot_photons(&pass, job).ok_or(Cancelled)
        })?;
        context.photons = Some(pass.finish(shards));
    }
    save_photons(&context, options, &preparation)?;
    radiosity::collect(&mut context, camera, options, &preparation)?;
    Ok(context)
}
