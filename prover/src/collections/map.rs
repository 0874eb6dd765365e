//! A map that costs little to compile.
//!
//! Every pair of types in a `BTreeMap` compiles a whole search tree, and every user of the macro builds them all. Maps
//! of the engine have few keys: two lists will do.

use core::cmp::Ordering;

/// Values by keys, in the order of the keys.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SortedMap<K, V> {
    keys: Vec<K>,
    values: Vec<V>,
}

impl<K, V> Default for SortedMap<K, V> {
    fn default() -> Self {
        Self::new()
    }
}

impl<K, V> SortedMap<K, V> {
    /// An empty map.
    pub const fn new() -> Self {
        Self { keys: Vec::new(), values: Vec::new() }
    }

    /// The number of keys.
    pub fn len(&self) -> usize {
        self.keys.len()
    }

    /// Whether there are no keys.
    pub fn is_empty(&self) -> bool {
        self.keys.is_empty()
    }

    /// The keys, ascending.
    pub fn keys(&self) -> core::slice::Iter<'_, K> {
        self.keys.iter()
    }

    /// The values, in the order of their keys.
    pub fn values(&self) -> core::slice::Iter<'_, V> {
        self.values.iter()
    }

    /// The values without their keys.
    pub fn into_values(self) -> Vec<V> {
        self.values
    }

    /// Keys and values.
    pub fn iter(&self) -> core::iter::Zip<core::slice::Iter<'_, K>, core::slice::Iter<'_, V>> {
        self.keys.iter().zip(&self.values)
    }
}

impl<V> SortedMap<String, V> {
    /// The value of a name.
    pub fn named(&self, name: &str) -> Option<&V> {
        let position = self.keys.binary_search_by(|key| key.as_str().cmp(name)).ok()?;
        self.values.get(position)
    }
}

impl<K: Ord, V> SortedMap<K, V> {
    /// The value of a key.
    pub fn get(&self, key: &K) -> Option<&V> {
        let position = self.keys.binary_search(key).ok()?;
        self.values.get(position)
    }

    /// Whether the key has a value.
    pub fn contains_key(&self, key: &K) -> bool {
        self.keys.binary_search(key).is_ok()
    }

    /// Sets the value of a key and gives the one it had.
    pub fn insert(&mut self, key: K, value: V) -> Option<V> {
        match self.keys.binary_search(&key) {
            Ok(position) => Some(core::mem::replace(&mut self.values[position], value)),
            Err(position) => {
                self.keys.insert(position, key);
                self.values.insert(position, value);
                None
            }
        }
    }

    /// The value of a key, which is added with a first value if it has none.
    pub fn get_or_insert_with(&mut self, key: K, first: impl FnOnce() -> V) -> &mut V {
        // Keys often come in order.
        let last = match self.keys.last() {
            None => Err(0),
            Some(last) => match last.cmp(&key) {
                Ordering::Less => Err(self.keys.len()),
                Ordering::Equal => Ok(self.keys.len() - 1),
                Ordering::Greater => self.keys.binary_search(&key),
            },
        };
        let position = last.unwrap_or_else(|position| {
            self.keys.insert(position, key);
            self.values.insert(position, first());
            position
        });
        &mut self.values[position]
    }

    /// Takes a key out and gives its value.
    pub fn remove(&mut self, key: &K) -> Option<V> {
        let position = self.keys.binary_search(key).ok()?;
        self.keys.remove(position);
        Some(self.values.remove(position))
    }

    /// Takes out all keys for which this is false.
    pub fn retain(&mut self, mut keep: impl FnMut(&K, &mut V) -> bool) {
        let mut position = 0;
        while position < self.keys.len() {
            if keep(&self.keys[position], &mut self.values[position]) {
                position += 1;
            } else {
                self.keys.remove(position);
                self.values.remove(position);
            }
        }
    }
}

impl<K, V> IntoIterator for SortedMap<K, V> {
    type Item = (K, V);
    type IntoIter = core::iter::Zip<std::vec::IntoIter<K>, std::vec::IntoIter<V>>;
    fn into_iter(self) -> Self::IntoIter {
        self.keys.into_iter().zip(self.values)
    }
}

impl<'a, K, V> IntoIterator for &'a SortedMap<K, V> {
    type Item = (&'a K, &'a V);
    type IntoIter = core::iter::Zip<core::slice::Iter<'a, K>, core::slice::Iter<'a, V>>;
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use basis_test_support::Random;

    use super::SortedMap;

    #[test]
    fn does_what_a_search_tree_does() {
        let (mut ours, mut theirs) = (SortedMap::new(), BTreeMap::new());
        let mut random = Random::new(1);
        for step in 0..2000 {
            let key = random.below(64);
            match random.below(4) {
                0 => assert_eq!(ours.remove(&key), theirs.remove(&key)),
                1 => assert_eq!(ours.insert(key, step), theirs.insert(key, step)),
                2 => assert_eq!(ours.get_or_insert_with(key, || step), theirs.entry(key).or_insert(step)),
                3 if key == 7 => {
                    ours.retain(|key, value| (*key ^ *value) & 1 == 0);
                    theirs.retain(|key, value| (*key ^ *value) & 1 == 0);
                }
                _ => assert_eq!(ours.contains_key(&key), theirs.contains_key(&key)),
            }
            assert_eq!(ours.get(&key), theirs.get(&key));
            assert!(ours.iter().eq(&theirs));
            assert!(ours.clone().into_iter().eq(theirs.clone()));
            assert_eq!((ours.len(), ours.is_empty()), (theirs.len(), theirs.is_empty()));
        }
    }
}
