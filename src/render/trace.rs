//! From a ray to its light: what surfaces send back, what they mirror, what comes through them.

use super::mirror::{self, Incoming, Mirror};
use super::random::Random;
use super::refract::{Interface, Interiors, copied, reflect};
use super::shading_point::{Coat, ShadingPoint};
use super::{Options, Rays, Watch};
use crate::atmosphere::{Segment, ViewKind};
use crate::camera::{Lens, View};
use crate::color::{Rgb, gray};
use crate::math::{DVec2, DVec3, Range, Ray};
use crate::world::{Blocker, Intersection, ObjectInfo, World};
use smallvec::SmallVec;

/// So many surfaces one ray transmittance at most; it ends what rounding would keep in one place for ever.
const CROSSINGS: usize = 20_000;

/// The watcher is asked once in so many surfaces.
const ASK_EVERY: u32 = 64;

/// What `+Q` switches.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quality {
    /// From 2 on: lights shine.
    pub lit: bool,
    /// From 4 on.
    pub shadows: bool,
    /// From 5 on: `area_light`s are more than one light.
    pub extended: bool,
    /// From 6 on: no quick colours, and what is see-through shows what is behind.
    pub real: bool,
    /// From 8 on: mirrors and bumps.
    pub mirrors: bool,
    /// From 9 on: fog and rainbows.
    pub air: bool,
}

impl Quality {
    /// What a number from 0 to 11 switches on (measured on POV-Ray 3.7).
    fn new(q: u8) -> Self {
        Self { lit: q >= 2, shadows: q >= 4, extended: q >= 5, real: q >= 6, mirrors: q >= 8, air: q >= 9 }
    }
}

/// What is the same for all rays of a frame.
pub(super) struct Setup<'w> {
    pub world: &'w World,
    pub view: View,
    /// Of the camera: unit vectors right, up and ahead.
    axes: [DVec3; 3],
    pub quality: Quality,
    /// How far the camera sees.
    reach: f64,
    frame: u32,
    /// The picture keeps alpha.
    alpha: bool,
    /// What the camera is in, if that is the same for all rays.
    start: Interiors,
    /// Must rays know what they are in?
    pub asks_inside: bool,
}

impl<'w> Setup<'w> {
    pub fn new(world: &'w World, options: &Options) -> Self {
        let view = world.eye.view(options.width, options.height);
        let quality = Quality::new(options.quality);
        let mut start = Interiors::new();
        let asks_inside = world.asks_inside();
        if let Some(origin) = view.origin().filter(|_| asks_inside) {
            start = around(world, origin);
        }
        let (axes, _) = world.eye.frame.axes();
        let reach = view.reach();
        Self { world, reach, view, axes, quality, frame: options.frame, alpha: options.alpha, start, asks_inside }
    }
}

/// Light along a camera ray, in the numbers of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    pub rgb: Rgb,
    /// How much of what is behind the scene shows.
    pub passed: f64,
}

impl Sample {
    /// Where the camera sees nothing at all: black, or nothing in a picture that keeps alpha (measured on POV-Ray 3.7).
    const NOTHING: Self = Self { rgb: Rgb::ZERO, passed: 1.0 };
}

/// What a camera at a place is in.
fn around(world: &World, origin: DVec3) -> Interiors {
    let mut inside = Interiors::new();
    world.geometry.containing(origin, &mut |item| {
        let interior = world.objects[item.object() as usize].interior;
        inside.extend((interior != ObjectInfo::VIEW).then_some(interior));
    });
    inside.sort_unstable();
    inside
}

/// A ray and what is known of it.
pub(super) struct Path {
    pub ray: Ray,
    /// 1 for a ray from the eye.
    pub level: u32,
    /// How much it counts.
    pub weight: f64,
    /// Has it been mirrored?
    pub mirrored: bool,
    /// Has it passed a surface?
    pub passed: bool,
    /// What it is in.
    pub inside: Interiors,
    /// Where it stands in the spectrum, from 0 for red to 1 for violet; `None` for white light.
    pub hue: Option<f64>,
}

/// Where a ray goes on behind a surface.
enum Onward {
    /// Nowhere.
    Ends,
    /// Through it, in this direction.
    Through(DVec3),
    /// It is mirrored, all of it.
    Total,
    /// It would be, but counts too little.
    Lost,
    /// It splits into so many colours.
    Splits(u32),
}

/// What a ray crosses or is thrown back by.
struct Border<'a, 'w> {
    shading: &'a ShadingPoint<'w>,
    interface: &'a Interface,
    /// What is left of light on its way from the side where the ray comes from.
    fade: Rgb,
}

/// One way on from a border.
struct Way {
    dir: DVec3,
    /// Is it that of what is totally reflected?
    total: bool,
    /// How much of its light is seen.
    light: Rgb,
    /// How much the ray counts to what it did.
    weight: f64,
    /// How much shows of what is behind the scene.
    passed: f64,
}

impl Way {
    /// Takes the same way of another coat along.
    fn join(&mut self, other: &Way) {
        self.light += other.light;
        self.weight = self.weight.max(other.weight);
        self.passed += other.passed;
    }
}

/// Traces the rays of one sample after another.
pub(super) struct Tracer<'w> {
    pub setup: &'w Setup<'w>,
    pub rays: Rays,
    pub random: Random,
    /// Who may want it to stop.
    watch: Option<&'w dyn Watch>,
    stopped: bool,
    crossings: u32,
    /// What was in the way of each light's last ray.
    pub blockers: Vec<Option<Blocker>>,
}

impl<'w> Tracer<'w> {
    pub fn new(setup: &'w Setup<'w>, watch: Option<&'w dyn Watch>) -> Self {
        let (rays, random) = (Rays::default(), Random::new(setup.frame));
        let blockers = vec![None; setup.world.lights.len()];
        Self { setup, rays, random, watch, stopped: false, crossings: 0, blockers }
    }

    /// Has the watcher asked to stop? What was traced since is worth nothing.
    pub fn stopped(&self) -> bool {
        self.stopped
    }

    /// Counts a surface; asks the watcher once in a while, because mirrors that face each other can keep a single ray for
    /// hours.
    fn cross(&mut self) {
        self.crossings += 1;
        if self.crossings == ASK_EVERY {
            self.crossings = 0;
            self.stopped |= self.watch.is_some_and(|watch| watch.cancelled());
        }
    }

    /// All random numbers from here on belong to this sample of this pixel.
    pub fn begin(&mut self, pixel: u64, sample: u64) {
        self.random.begin(pixel, sample);
    }

    /// The light through a point of the picture, in pixels from its top left corner.
    pub fn see(&mut self, x: f64, y: f64) -> Sample {
        let count = self.setup.view.count();
        if count > 1 {
            return self.see_several(x, y, count);
        }
        self.setup.view.ray(x, y).map_or(Sample::NOTHING, |ray| self.look(ray))
    }

    /// The mean of all rays that there are.
    fn see_several(&mut self, x: f64, y: f64, count: usize) -> Sample {
        let (mut sum, mut found) = (Sample::NOTHING, 0.0);
        for number in 0..count {
            let Some(ray) = self.setup.view.ray_of(x, y, number) else { continue };
            let seen = self.look(ray);
            (sum.rgb, sum.passed, found) = (sum.rgb + seen.rgb, sum.passed + seen.passed, found + 1.0);
        }
        if found == 0.0 { Sample::NOTHING } else { Sample { rgb: sum.rgb / found, passed: sum.passed / found } }
    }

    /// The same through a place of a lens, which is two numbers in [0, 1).
    pub fn see_through(&mut self, x: f64, y: f64, lens: &Lens, place: DVec2) -> Sample {
        let ray = self.setup.view.ray(x, y).map(|ray| lens.through(&ray, place, &self.setup.axes));
        ray.map_or(Sample::NOTHING, |ray| self.look(ray))
    }

    fn look(&mut self, ray: Ray) -> Sample {
        self.rays.camera += 1;
        let Setup { world, view, start, asks_inside, .. } = self.setup;
        let inside = match view.origin() {
            None if *asks_inside => around(world, ray.origin),
            _ => copied(start),
        };
        self.follow(Path { ray, level: 1, weight: 1.0, mirrored: false, passed: false, inside, hue: None })
    }

    /// Follows a ray through all that lets it pass; only mirrors and dispersion recurse.
    pub(super) fn follow(&mut self, mut path: Path) -> Sample {
        let mut rgb = Rgb::ZERO;
        // How much of the light ahead arrives.
        let mut through = Rgb::ONE;
        let mut passed = 1.0;
        // What shows of what is behind the scene on the ways that were left.
        let mut behind = 0.0;
        for _ in 0..CROSSINGS {
            self.cross();
            self.random.next_vertex();
            if self.stopped {
                break;
            }
            let Some(found) = self.closest(&path) else {
                let veil = self.veil(&path.ray, Segment::FAR, &path.inside).before(self.sky(&path));
                let open = if path.mirrored && self.setup.alpha { 0.0 } else { gray(veil.transmittance) };
                return Sample { rgb: rgb + through * veil.radiance, passed: behind + passed * open };
            };
            let veil = self.veil(&path.ray, found.t(), &path.inside);
            rgb += through * veil.radiance;
            through *= veil.transmittance;
            passed *= gray(veil.transmittance);
            let world = self.setup.world;
            let own = world.parts[found.part() as usize].interior;
            let mut interface = match self.setup.asks_inside {
                true => Interface::new(&path.inside, own, &world.interiors),
                false => Interface::NONE,
            };
            if let Some(hue) = path.hue {
                interface = interface.of_hue(hue, &path.inside, own, &world.interiors);
            }
            let shading = ShadingPoint::new(world, &path.ray, &found, &self.setup.quality, &interface);
            rgb += through * self.shade(&path, &shading);
            // Only light from behind has faded, not what the far side sends back or mirrors (measured on 3.7).
            let fade = match world.colors_light && interface.leaves() {
                true => self.faded(shading.part.interior, found.t()),
                false => Rgb::ONE,
            };
            // (A loop: an iterator that is collected returns each through memory.)
            let mut onward = SmallVec::<[Onward; 1]>::new();
            for coat in &shading.coats {
                onward.push(self.onward(&path, coat, &interface, own));
            }
            if self.setup.quality.mirrors {
                rgb += through * self.mirrored(&path, &shading, &interface, &onward);
            }
            if onward.iter().all(|onward| matches!(onward, Onward::Ends | Onward::Lost)) {
                return Sample { rgb, passed: behind };
            }
            let border = Border { shading: &shading, interface: &interface, fade };
            let mut ways = self.ways(&path, &border, &onward, &mut rgb, through);
            let Some(last) = ways.pop() else { return Sample { rgb, passed: behind } };
            for way in ways {
                let mut path = Path { inside: copied(&path.inside), ..path };
                self.go(&mut path, &border, &way);
                let seen = self.follow(path);
                rgb += through * way.light * seen.rgb;
                behind += passed * way.passed * seen.passed;
            }
            through *= last.light;
            passed *= last.passed;
            self.go(&mut path, &border, &last);
        }
        Sample { rgb, passed: behind }
    }

    /// Where a ray goes on behind a surface, each way once; what splits into colours is followed at once.
    fn ways(
        &mut self,
        path: &Path,
        border: &Border,
        onward: &[Onward],
        rgb: &mut Rgb,
        through: Rgb,
    ) -> SmallVec<[Way; 1]> {
        let Border { shading, interface, fade } = *border;
        let mut ways = SmallVec::<[Way; 1]>::new();
        for (coat, onward) in shading.coats.iter().zip(onward) {
            let way = match *onward {
                Onward::Ends | Onward::Lost => continue,
                Onward::Through(dir) => Way {
                    dir,
                    total: false,
                    // What has faded counts as if it had not (measured on 3.7).
                    light: coat.share * fade * coat.pass,
                    weight: coat.pass.abs().max_element(),
                    // (So measured, as a product of two grays.)
                    passed: coat.share * gray(coat.pass) * gray(fade),
                },
                Onward::Total => {
                    // It takes no more from the light, but the ray counts less (measured on 3.7).
                    let dir = bounce(path.ray.dir, coat.normal, shading.smooth);
                    let light = coat.share * fade * mirror::total(coat, shading.point, dir, self.setup.world);
                    Way { dir, total: true, light, weight: coat.pass.max_element(), passed: 0.0 }
                }
                Onward::Splits(samples) => {
                    let path =
                        Path { inside: copied(&path.inside), weight: path.weight * coat.pass.max_element(), ..*path };
                    let split = self.split(&path, (shading, coat), interface, samples);
                    *rgb += through * coat.share * fade * coat.pass * split;
                    continue;
                }
            };
            match ways.iter_mut().find(|known| known.dir == way.dir && known.total == way.total) {
                Some(known) => known.join(&way),
                None => ways.push(way),
            }
        }
        ways
    }

    /// Takes a ray one step on.
    fn go(&mut self, path: &mut Path, border: &Border, way: &Way) {
        path.weight *= way.weight;
        path.ray = Ray::new(border.shading.point, way.dir);
        if way.total {
            (path.level, path.mirrored) = (path.level + 1, true);
            self.rays.reflected += 1;
            return;
        }
        path.passed = true;
        // Straight on it stays on its level (measured on 3.7).
        path.level += u32::from(border.interface.bends());
        if self.setup.asks_inside {
            border.interface.cross(&mut path.inside, border.shading.part.interior);
        }
        self.rays.transmitted += 1;
    }

    fn closest(&self, path: &Path) -> Option<Intersection<'w>> {
        let world = self.setup.world;
        let range = Range { min: world.epsilon.surface, max: f64::INFINITY };
        if path.mirrored {
            world.geometry.closest(&path.ray, range, |id| world.objects[id as usize].reflection)
        } else if path.passed {
            world.geometry.closest(&path.ray, range, |id| world.objects[id as usize].through)
        } else {
            let range = Range { max: self.setup.reach, ..range };
            world.geometry.closest(&path.ray, range, |id| world.objects[id as usize].image)
        }
    }

    /// What lies behind everything.
    fn sky(&self, path: &Path) -> Segment {
        let Setup { world, quality, alpha, .. } = self.setup;
        if *alpha && !path.mirrored && world.sky.leaves_alpha() {
            return Segment::NONE;
        }
        let beholder = match alpha {
            true if path.mirrored => ViewKind::Mirror,
            true => ViewKind::Alpha,
            false => ViewKind::Opaque,
        };
        world.sky.toward(path.ray.dir, beholder, !quality.real, world.noise, world.waves)
    }

    /// Does the ray go on behind a coat of the border of `own`, and where to? It must count enough by its largest
    /// channel, and this surface alone by its gray; if only the former is too little, what is totally reflected is not seen in
    /// the mirror either (all measured on 3.7).
    fn onward(&self, path: &Path, coat: &Coat, interface: &Interface, own: u32) -> Onward {
        let world = self.setup.world;
        let pass = coat.pass;
        // (What is passed on as less than nothing counts as much as if it were more: measured on 3.7.)
        let clear = self.setup.quality.real && pass != Rgb::ZERO && gray(pass).abs() > world.adc_bailout;
        if !clear || path.level >= world.max_trace_level {
            return Onward::Ends;
        }
        if path.weight * pass.abs().max_element() <= world.adc_bailout {
            let total = interface.refract(path.ray.dir, coat.normal).is_none();
            return if total { Onward::Lost } else { Onward::Ends };
        }
        if world.disperses
            && path.hue.is_none()
            && let Some(samples) = interface.samples(&path.inside, own, &world.interiors)
        {
            return Onward::Splits(samples);
        }
        interface.refract(path.ray.dir, coat.normal).map_or(Onward::Total, Onward::Through)
    }

    /// The light that the place mirrors. What is totally reflected takes the place of the mirrors of its coat with the same bumps
    /// (measured on 3.7).
    fn mirrored(&mut self, path: &Path, shading: &ShadingPoint, interface: &Interface, onward: &[Onward]) -> Rgb {
        let world = self.setup.world;
        let mut sum = Rgb::ZERO;
        if path.level >= world.max_trace_level {
            return sum;
        }
        let mut mirrors = SmallVec::<[Mirror; 2]>::new();
        for (coat, onward) in shading.coats.iter().zip(onward) {
            let taken = matches!(onward, Onward::Total | Onward::Lost).then_some(coat.normal);
            mirrors.extend(coat.layers.iter().filter_map(|shaded| {
                let reflection = shaded.layer.finish.mirror.as_deref()?;
                (taken != Some(shaded.normal)).then_some(Mirror { reflection, shaded, share: coat.share })
            }));
        }
        let incoming = Incoming { weight: path.weight, interface, world };
        for mirrored in mirror::bounces(&mirrors, incoming) {
            self.rays.reflected += 1;
            let out = bounce(path.ray.dir, mirrored.normal, shading.smooth);
            let ray = Ray::new(shading.point, out);
            let (level, weight, inside) = (path.level + 1, mirrored.weight, copied(&path.inside));
            let light = self.follow(Path { ray, level, weight, mirrored: true, inside, ..*path }).rgb;
            sum += mirror::answer(&mirrors, shading.point, incoming, mirrored, out, light);
        }
        sum
    }
}

/// Where bumps mirror a ray to. What they would send into the surface, the surface mirrors again; and bumps that are seen from
/// behind do not count (measured on POV-Ray 3.7).
pub(super) fn bounce(dir: DVec3, normal: DVec3, smooth: DVec3) -> DVec3 {
    let out = reflect(dir, normal);
    match out.dot(smooth) < 0.0 {
        true if dir.dot(normal) > 0.0 => reflect(dir, smooth),
        true => reflect(out, smooth),
        false => out,
    }
}
