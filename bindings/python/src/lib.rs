//! `raylet._raylet`: the part of the Python package that is in Rust. `python/raylet/__init__.pyi` documents it.
//!
//! | module | what it holds |
//! |---|---|
//! | `recipe` | a shape by its sizes, made anew in each number type |
//! | `number` | the number types as NumPy has them |
//! | `query` | many rays at one shape, on all cores |

mod number;
mod query;
mod recipe;

use number::Number;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray2, PyUntypedArray, PyUntypedArrayMethods, dtype};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use query::{Tiers, Wanted};
use recipe::Recipe;

fn refused(error: raylet::Error) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// A solid or an open surface, placed in the world.
#[pyclass(frozen, module = "raylet")]
#[derive(Clone)]
struct Shape {
    recipe: Recipe,
}

impl Shape {
    /// A shape that can be made in the widest number type.
    fn checked(recipe: Recipe) -> PyResult<Self> {
        recipe.shape::<f64>().map_err(refused)?;
        Ok(Self { recipe })
    }

    fn answer<'py, N: Number>(
        &self,
        py: Python<'py>,
        origins: &Bound<'py, PyAny>,
        directions: &Bound<'py, PyAny>,
        wanted: Wanted,
        tier: &str,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let shape = self.recipe.shape::<N::Scalar>().map_err(refused)?;
        let tier = Tiers::named(tier).ok_or_else(|| PyValueError::new_err("tier is plain, fast, stable or exact"))?;
        if matches!(tier, Tiers::Exact) && !N::HAS_EXACT {
            return Err(PyValueError::new_err("float64 has no tier exact; float32 and int32 have one"));
        }
        let [origins, directions] = [origins, directions].map(|array| array.extract::<PyReadonlyArray2<'py, N>>());
        let (origins, directions) = (origins?, directions?);
        if origins.shape() != directions.shape() || origins.shape()[1] != 3 {
            return Err(PyValueError::new_err("origins and directions must both have the shape (n, 3)"));
        }
        let message = "origins and directions must be C-contiguous: numpy.ascontiguousarray makes them so";
        let contiguous = |_| PyValueError::new_err(message);
        let (from, along) = (origins.as_slice().map_err(contiguous)?, directions.as_slice().map_err(contiguous)?);
        let threads = threads.or_else(|| std::thread::available_parallelism().ok().map(Into::into)).unwrap_or(1);
        let found = py.detach(|| query::nearest::<N>(&shape, from, along, wanted, tier, threads));
        let found = found.map_err(|(ray, error)| PyValueError::new_err(format!("ray {ray}: {error}")))?;
        let result = PyDict::new(py);
        result.set_item("t", found.t.into_pyarray(py))?;
        result.set_item("part", found.part.into_pyarray(py))?;
        result.set_item("crossing", found.crossing.into_pyarray(py))?;
        if wanted.normals {
            result.set_item("normal", in_threes(found.normal.into_pyarray(py))?)?;
        }
        Ok(result)
    }
}

fn in_threes<'py, N: numpy::Element>(flat: Bound<'py, PyArray1<N>>) -> PyResult<Bound<'py, PyAny>> {
    flat.call_method1("reshape", ((-1, 3),))
}

#[pymethods]
impl Shape {
    /// A shape of this kind and these sizes.
    #[new]
    fn new(kind: &str, sizes: Vec<f64>) -> PyResult<Self> {
        let recipe = Recipe::new(kind, &sizes).map_err(PyValueError::new_err)?;
        Self::checked(recipe)
    }

    /// The same shape with its base there and its y axis along a vector of any length.
    fn standing(&self, base: [f64; 3], axis: [f64; 3]) -> PyResult<Self> {
        Self::checked(self.recipe.clone().standing(base, axis))
    }

    /// The same shape moved there and turned by a quaternion (x, y, z, w).
    fn turned(&self, position: [f64; 3], quaternion: [f64; 4]) -> PyResult<Self> {
        Self::checked(self.recipe.clone().turned(position, quaternion))
    }

    /// The same shape stretched along its own axes.
    fn stretched(&self, factors: [f64; 3]) -> PyResult<Self> {
        Self::checked(self.recipe.clone().stretched(factors))
    }

    /// The nearest hits of many rays.
    #[pyo3(signature = (origins, directions, tier = "stable", normals = false, threads = None))]
    fn nearest<'py>(
        &self,
        py: Python<'py>,
        origins: Bound<'py, PyUntypedArray>,
        directions: Bound<'py, PyUntypedArray>,
        tier: &str,
        normals: bool,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyDict>> {
        use numpy::PyArrayDescrMethods;
        let (numbers, wanted) = (origins.dtype(), Wanted { normals });
        let (origins, directions) = (origins.as_any(), directions.as_any());
        if numbers.is_equiv_to(&dtype::<f32>(py)) {
            self.answer::<f32>(py, origins, directions, wanted, tier, threads)
        } else if numbers.is_equiv_to(&dtype::<f64>(py)) {
            self.answer::<f64>(py, origins, directions, wanted, tier, threads)
        } else if numbers.is_equiv_to(&dtype::<i32>(py)) {
            self.answer::<i32>(py, origins, directions, wanted, tier, threads)
        } else {
            Err(PyTypeError::new_err("arrays must be float32, float64, or int32 for I16F16 in units of 2^-16"))
        }
    }

    fn __repr__(&self) -> String {
        self.recipe.to_string()
    }
}

/// The parts of a surface, by the number that a hit has.
#[pyfunction]
fn parts() -> Vec<String> {
    raylet::Part::EVERY.iter().map(|part| format!("{part:?}").to_lowercase()).collect()
}

#[pymodule]
fn _raylet(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Shape>()?;
    module.add_function(wrap_pyfunction!(parts, module)?)?;
    Ok(())
}
