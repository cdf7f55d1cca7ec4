//! Which of the three channels a ray carries: dispersion sends them different ways.

/// A set of the channels red (0), green (1) and blue (2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Channels(u8);

impl Channels {
    /// All three.
    pub const ALL: Channels = Channels(0b111);
    /// None.
    pub const NONE: Channels = Channels(0);

    /// Whether the set holds the channel.
    pub fn contains(self, channel: usize) -> bool {
        self.0 >> channel & 1 == 1
    }

    /// Adds a channel.
    pub fn insert(&mut self, channel: usize) {
        self.0 |= 1 << channel;
    }

    /// Whether the set is empty.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The channels that are in this set and for which the number is more than zero.
    pub fn where_positive(self, values: lancer_scene::Rgb) -> Channels {
        self.iter().filter(|&channel| values[channel] > 0.0).collect()
    }

    /// The channels of either set.
    pub fn union(self, other: Channels) -> Channels {
        Channels(self.0 | other.0)
    }

    /// The channels in their order.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..3).filter(move |&channel| self.contains(channel))
    }
}

impl FromIterator<usize> for Channels {
    fn from_iter<I: IntoIterator<Item = usize>>(channels: I) -> Channels {
        let mut set = Channels::NONE;
        channels.into_iter().for_each(|channel| set.insert(channel));
        set
    }
}
