//! Range sensors: readings beside a plain search of all hits, the rays of zones and sweeps beside doubles, errors
//! beside their distribution; and queries by the first numbers of a tier alone.

/// Calls a test in all tiers of all number types.
#[cfg(test)]
macro_rules! in_every_tier {
    ($test:ident) => {
        in_every_tier!($test: f32, raylet::Plain, raylet::Fast, raylet::Stable, raylet::Exact);
        in_every_tier!($test: f64, raylet::Plain, raylet::Fast, raylet::Stable);
        in_every_tier!($test: fixed::types::I16F16, raylet::Plain, raylet::Fast, raylet::Stable, raylet::Exact);
        in_every_tier!($test: fixed::types::I8F24, raylet::Plain, raylet::Fast, raylet::Stable, raylet::Exact);
        in_every_tier!($test: fixed::types::I32F32, raylet::Plain, raylet::Fast, raylet::Stable);
    };
    ($test:ident: $S:ty, $($T:ty),+) => { $($test::<$S, $T>();)+ };
}

#[cfg(test)]
mod extremes;
#[cfg(test)]
mod firmware;
#[cfg(test)]
mod first_numbers;
#[cfg(test)]
mod noise;
#[cfg(test)]
mod rays;
#[cfg(test)]
mod readings;
#[cfg(test)]
mod refusals;
#[cfg(test)]
mod yard;
