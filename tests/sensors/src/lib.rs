//! Range sensors: readings beside a plain search of all hits, the rays of zones and sweeps beside doubles, errors
//! beside their distribution; and queries by the first numbers of a tier alone.

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
