//! The formulas that everyone writes first, at the rays of the subjects: `nearest` of the tier `textbook`, for three
//! solids and two of them framed.

use super::{Case, KINDS, Name};
use raylet::{Cone, Cylinder, Ray, Shape, Sphere};
use shared::rays::rays;
use shared::subject::{eighths, frame};
use std::hint::black_box;
use support::oracle::{ConeExtent, CylinderExtent, Solid};
use support::placed::{Placed, Placement};
use support::textbook::{Form, Place, Plain, PlainRay};

/// A solid, and where it stands.
type Model<N> = (Form<N>, Option<Place<N>>);

#[inline(never)]
fn nearest<S: Plain>((form, place): &Model<S::Number>, ray: &PlainRay<S::Number>) {
    black_box(form.nearest(place.as_ref(), ray));
}

/// A subject as the library and as the formulas see it, and whether it is framed.
type Of<S> = (&'static str, Shape<S>, Solid, bool);

/// The subjects; `None` if a size does not fit the type.
fn subjects<S: Plain>() -> Option<[Of<S>; 5]> {
    let (radius, slope, height) = (eighths::<S>(8), eighths::<S>(6), eighths::<S>(12));
    let ball = Solid::Sphere { radius: radius.exact() };
    let tube = Solid::Cylinder { radius: radius.exact(), extent: CylinderExtent::Capped(height.exact()) };
    let cone = Solid::Cone { slope: slope.exact(), extent: ConeExtent::Capped(height.exact()) };
    let [sphere, cylinder, capped] = [
        Shape::new(Sphere::new(radius).ok()?),
        Shape::new(Cylinder::capped(radius, height).ok()?),
        Shape::new(Cone::capped(slope, height).ok()?),
    ];
    Some([
        ("sphere", sphere, ball.clone(), false),
        ("cylinder, capped", cylinder, tube, false),
        ("cone, capped", capped, cone.clone(), false),
        ("sphere, framed", sphere, ball, true),
        ("cone, capped, framed", capped, cone, true),
    ])
}

/// The cases of a number type.
pub fn cases<S>(number: &'static str) -> Vec<Case>
where
    S: Plain<Number: Send + Sync>,
{
    let mut cases = Vec::new();
    for (subject, shape, solid, is_framed) in subjects::<S>().into_iter().flatten() {
        let placement = frame().filter(|_| is_framed).map(Placement::Frame);
        let placed = placement.and_then(|placement| Placed::by(&shape, &solid, placement).ok());
        let model: Model<S::Number> = (Form::of::<S>(&solid), placed.as_ref().map(Place::of));
        let shape = placed.map_or(shape, |placed| placed.shape);
        for (hitting, kind) in KINDS {
            let plain = |ray: &Ray<S>| PlainRay::of(ray);
            let inputs: Vec<_> = rays(&shape, hitting).iter().map(plain).collect();
            let name = Name { subject: subject.into(), query: "nearest", number, tier: "textbook", rays: kind };
            cases.push(Case::new(name, model, inputs, nearest::<S>));
        }
    }
    cases
}
