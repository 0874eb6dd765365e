//! What finite elements ask of families: rules of quadrature on their cells, functions and derivatives at many points at
//! once, nodes, and which functions belong to which corner, edge or face.

mod cell;
mod entities;
mod nodes;
mod quadrature;
mod symmetric;
mod tabulation;

pub(crate) use cell::{Factor, product};
pub(crate) use entities::in_cell;
pub use entities::{Entities, Entity};
pub(crate) use nodes::{box_nodes, interval_nodes, product_nodes, simplex_nodes};
pub use quadrature::{Quadrature, QuadratureError};
pub use tabulation::Tabulation;
pub(crate) use tabulation::{tabulate_box, tabulate_interval, tabulate_product, tabulate_simplex};
