//! The names of the material presets, their families, and where their numbers come from.

phrases! {
    /// A metal.
    chrome() { "chrome", "chrome" }
    /// A metal.
    silver() { "silver", "argent" }
    /// A metal.
    gold() { "gold", "or" }
    /// A metal.
    copper() { "copper", "cuivre" }
    /// A metal.
    brass() { "brass", "laiton" }
    /// A metal.
    aluminium() { "aluminium", "aluminium" }
    /// A metal.
    iron() { "iron", "fer" }
    /// A perfect mirror.
    mirror() { "mirror", "miroir" }
    /// A crown glass.
    glass() { "glass", "verre" }
    /// A glass that parts the colours.
    flint_glass() { "flint glass", "verre flint" }
    /// Green glass.
    bottle_glass() { "bottle glass", "verre à bouteille" }
    /// Water.
    water() { "water", "eau" }
    /// Ice.
    ice() { "ice", "glace" }
    /// Diamond.
    diamond() { "diamond", "diamant" }
    /// A thin film around nothing.
    soap_bubble() { "soap bubble", "bulle de savon" }
    /// A dull white.
    plaster() { "plaster", "plâtre" }
    /// Fired clay.
    terracotta() { "terracotta", "terre cuite" }
    /// A shiny red.
    plastic() { "plastic", "plastique" }
    /// A dull black.
    rubber() { "rubber", "caoutchouc" }
    /// Polished white stone.
    marble() { "marble", "marbre" }
    /// Glazed white.
    porcelain() { "porcelain", "porcelaine" }
    /// A green stone.
    jade() { "jade", "jade" }
    /// A black glass.
    obsidian() { "obsidian", "obsidienne" }
    /// A black varnish.
    lacquer() { "lacquer", "laque" }
    /// Gives all the ambient light back.
    luminous() { "luminous", "lumineux" }

    /// The family of metals and mirrors.
    metals() { "Metals and mirrors", "Métaux et miroirs" }
    /// The family of what lets light through.
    transparent() { "Transparent", "Transparents" }
    /// The family of everything else.
    opaque() { "Opaque", "Opaques" }

    /// Reflectance of metals.
    source_metals() {
        "Kr: reflectance at normal incidence, Akenine-Möller et al., Real-Time Rendering, 4th edition, table 9.2",
        "Kr : réflectance en incidence normale, Akenine-Möller et al., Real-Time Rendering, 4e édition, table 9.2"
    }
    /// The index of a crown glass.
    source_glass() {
        "index 1.5168: Schott N-BK7 at 587.6 nm; Kr by Fresnel's law",
        "indice 1.5168 : N-BK7 de Schott à 587,6 nm ; Kr selon la loi de Fresnel"
    }
    /// The indices of a flint glass.
    source_flint_glass() {
        "indices of Schott N-SF10 at 656.3, 587.6 and 486.1 nm: each channel is refracted by itself",
        "indices du N-SF10 de Schott à 656,3, 587,6 et 486,1 nm : chaque canal est réfracté séparément"
    }
    /// The index of water.
    source_water() {
        "index 1.333: water at 20 °C and 589 nm (CRC Handbook of Chemistry and Physics); Kr by Fresnel's law",
        "indice 1.333 : eau à 20 °C et 589 nm (CRC Handbook of Chemistry and Physics) ; Kr selon la loi de Fresnel"
    }
    /// The index of ice.
    source_ice() {
        "index 1.309: ice at 589 nm (CRC Handbook of Chemistry and Physics); Kr by Fresnel's law",
        "indice 1.309 : glace à 589 nm (CRC Handbook of Chemistry and Physics) ; Kr selon la loi de Fresnel"
    }
    /// The index of diamond.
    source_diamond() {
        "index 2.419: diamond at 589 nm (CRC Handbook of Chemistry and Physics); Kr by Fresnel's law",
        "indice 2.419 : diamant à 589 nm (CRC Handbook of Chemistry and Physics) ; Kr selon la loi de Fresnel"
    }
    /// Coefficients of old.
    source_opengl() {
        "Ka, Kd, W and n: material tables of the OpenGL example teapots.c, M. Kilgard, 1994",
        "Ka, Kd, W et n : tables de matières de l'exemple OpenGL teapots.c, M. Kilgard, 1994"
    }
}
