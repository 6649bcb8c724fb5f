//! Scenes, pictures, and the reader of scenes.

use crate::everything::{any_ray, any_shape};
use crate::input::{Any, any_direction, any_point, any_text, any_word, give};
use raylet::Tracer;
use raylet::scene::nff::{self, Corner, Counts, Stores};
use raylet::scene::{Hierarchy, Node};
use raylet::{Camera, Color, Light, Material, Object, Picture, Scene, Size, TraceContext};

fn any_color<S: Any>() -> Color<S> {
    let [red, green, blue] = any_direction::<S>().to_array();
    Color::new(red, green, blue)
}

/// A camera made from its angle.
pub fn any_camera<S: Any>() -> Option<Camera<S>> {
    Camera::new(any_point(), any_point(), any_point(), S::any()).ok()
}

/// A beginning of a list, of a length that no compiler knows.
fn any_list<T>(list: &[T]) -> &[T] {
    list.get(..any_word() as usize).unwrap_or(list)
}

/// The same, to be written.
fn any_list_mut<T>(list: &mut [T]) -> &mut [T] {
    let length = list.len().min(any_word() as usize);
    list.split_at_mut_checked(length).map_or(&mut [], |(list, _)| list)
}

/// Everything that can be seen.
pub fn pictures<S: Any>(camera: Camera<S>) -> Option<()> {
    let objects = [Object::new(any_shape::<S>()?, any_word() as u32), Object::new(any_shape::<S>()?, 0).smooth(0)];
    let materials = [Material::matte(any_color()).with_highlight(S::any(), S::any())];
    let lights = [Light::new(any_point(), Light::usual_strength(any_word() as u32))];
    let normals = [[any_direction(), any_direction(), any_direction()]];
    let scene = Scene::new(&objects, &materials, &lights, camera).ok()?;
    let scene = scene.with_normals(&normals).ok()?.with_background(any_color());
    let mut nodes = [Node::EMPTY; 3];
    let hierarchy = Hierarchy::build(any_list(&objects), any_list_mut(&mut nodes)).ok()?;
    let scene = scene.with_hierarchy(&hierarchy).ok()?;
    let mut context = TraceContext::new(());
    let ray = any_ray::<S>()?;
    give(scene.nearest(&ray, &mut context.counters));
    give(scene.occludes(&ray, &mut context.counters));
    give(Tracer::new(&scene).look(&ray, &mut context));
    let size = Size::new(any_word() as u16, any_word() as u16).with_samples(any_word() as u8);
    let picture = Picture::new(&scene, size);
    give(scene.camera().raster(size).ray([any_word() as u16, any_word() as u16], [any_word() as u8, 0]));
    give(picture.pixel(any_word() as u16, any_word() as u16, &mut context));
    give(picture.render(|x, y, pixel| give((x, y, pixel.color.to_srgb888(), pixel.seen, pixel.lit_by))));
    let earlier = Scene::new(any_list(&objects), &materials, &lights, camera).ok()?;
    give(picture.render_changed(&Picture::new(&earlier, size), |x, y, pixel| give((x, y, pixel.seen))));
    give(picture.in_spans().render(|x, y, pixel| give((x, y, pixel.seen))));
    give((any_color::<S>().plus(any_color()), any_color::<S>().times(any_color())));
    Some(())
}

/// The reader of the Neutral File Format.
pub fn reader<S: Any>() -> Option<()> {
    let mut objects = heapless::Vec::<Object<S>, 4>::new();
    let mut materials = heapless::Vec::<Material<S>, 4>::new();
    let mut lights = heapless::Vec::<Light<S>, 4>::new();
    let mut normals = heapless::Vec::<_, 4>::new();
    let mut corners = [Corner::default(); 8];
    let stores = Stores {
        objects: &mut objects,
        materials: &mut materials,
        lights: &mut lights,
        normals: &mut normals,
        corners: &mut corners,
    };
    give(Counts::of(any_text()).corners);
    // The error is data; only its message would be text.
    give(nff::read::<S>(any_text(), stores).is_ok());
    give((objects.len(), materials.len(), lights.len(), normals.len()));
    give(S::parse(any_text()));
    Some(())
}
