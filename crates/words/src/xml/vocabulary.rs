//! One sentence for each element and attribute of the native documents, for the schema and the manual.

phrases! {
    /// `scene`
    scene() { "A scene: its surroundings, materials, lamps and objects", "Une scène : son milieu, ses matières, ses sources et ses objets" }
    /// `scene @version`, `views @version`
    version() { "The version of the format", "La version du format" }
    /// `scene @name`
    scene_name() { "The scene's title", "Le titre de la scène" }
    /// `world`
    world() { "What surrounds the objects, and how light is computed", "Ce qui entoure les objets, et comment la lumière est calculée" }
    /// `world @ambient`
    ambient() { "The ambient light", "La lumière ambiante" }
    /// `world @background`
    background() { "The colour of infinity, seen by every ray that meets nothing", "La couleur de l'infini, vue par tout rayon qui ne rencontre rien" }
    /// `world @index`
    world_index() { "The refraction index of the surrounding medium", "L'indice de réfraction du milieu ambiant" }
    /// `world @depth`
    world_depth() { "The depth limit: a ray of this level casts no further ray", "La profondeur limite : un rayon de ce niveau n'en lance plus d'autre" }
    /// `world @compose`
    compose() { "How the terms of a point are composed", "La façon de composer les termes d'un point" }
    /// `light`
    light() { "A point lamp, equally bright in every direction and at every distance", "Une source ponctuelle, de même intensité dans toutes les directions et à toute distance" }
    /// `light @name`, `object @name`
    object_name() { "Its name, unique among objects and lamps", "Son nom, unique parmi les objets et les sources" }
    /// `light @position`
    light_position() { "Where the lamp stands", "L'emplacement de la source" }
    /// `light @color`
    light_color() { "Its colour", "Sa couleur" }
    /// `object @visible`
    visible() { "Whether it takes part in the picture", "Si l'élément participe à l'image" }
    /// `material`
    material() { "What a surface does with light", "Ce qu'une surface fait de la lumière" }
    /// `material @name`
    material_name() { "Its name, unique among the materials; an inline material has none", "Son nom, unique parmi les matières ; une matière incluse n'en a pas" }
    /// `material @ka`
    ka() { "The share of the ambient light that it gives back", "La part de lumière ambiante qu'elle restitue" }
    /// `material @kd`
    kd() { "The share of a lamp's light that it scatters", "La part de la lumière d'une source qu'elle diffuse" }
    /// `material @ks`
    ks() { "The scale of the reflectance, for the highlight", "L'échelle de la réflectance, pour le reflet spéculaire" }
    /// `material @w`
    w() { "The law of the reflectance over the angle of the light", "La loi de la réflectance selon l'angle de la lumière" }
    /// `material @n`
    shininess() { "The shininess: the exponent of the highlight", "La brillance : l'exposant du reflet spéculaire" }
    /// `material @kr`
    kr() { "The share of the mirrored light", "La part de la lumière réfléchie" }
    /// `material @kt`
    kt() { "The share of the refracted light", "La part de la lumière réfractée" }
    /// `material @index`
    material_index() { "The refraction index of what the surface encloses", "L'indice de réfraction de ce que la surface enferme" }
    /// `material @highlight`
    highlight() { "Phong's or Blinn's highlight", "Le reflet de Phong ou de Blinn" }
    /// `object @material`
    object_material() { "The name of its material; a built-in grey if there is none", "Le nom de sa matière ; un gris par défaut sans elle" }
    /// `sphere`
    sphere() { "A sphere", "Une sphère" }
    /// `sphere @center`
    sphere_center() { "Its centre", "Son centre" }
    /// `sphere @radius`
    radius() { "Its radius", "Son rayon" }
    /// `plane`
    plane() { "The infinite plane through three points; it bounds the half-space behind its normal", "Le plan infini passant par trois points ; il borne le demi-espace derrière sa normale" }
    /// `facet`
    facet() { "One triangle, a sheet without thickness", "Un triangle, une feuille sans épaisseur" }
    /// `plane @p0`, `facet @p0`
    p0() { "The first point", "Le premier point" }
    /// `plane @p1`, `facet @p1`
    p1() { "The second point", "Le deuxième point" }
    /// `plane @p2`, `facet @p2`
    p2() { "The third point, not in line with the others", "Le troisième point, non aligné avec les autres" }
    /// `cube`
    cube() { "A cube of twelve facets", "Un cube de douze facettes" }
    /// `cube @center`
    cube_center() { "Its centre", "Son centre" }
    /// `cube @edge`
    edge() { "The length of its edges", "La longueur de ses arêtes" }
    /// `cube @rotation`
    cube_rotation() { "Degrees about the fixed axes x, y, z in turn, around its centre", "Degrés autour des axes fixes x, y puis z, autour de son centre" }
    /// `box`
    parallelepiped() { "A box of twelve facets, spanned by three edges", "Une boîte de douze facettes, engendrée par trois arêtes" }
    /// `box @origin`
    box_origin() { "One corner", "Un coin" }
    /// `box @u`
    box_u() { "The first edge that leaves the corner", "La première arête partant du coin" }
    /// `box @v`
    box_v() { "The second edge", "La deuxième arête" }
    /// `box @w`
    box_w() { "The third edge, not in the plane of the others", "La troisième arête, hors du plan des autres" }
    /// `cone`
    cone() { "A right circular cone between two circles, a cylinder where their radii are equal", "Un cône droit entre deux cercles, un cylindre si leurs rayons sont égaux" }
    /// `cone @base`
    cone_base() { "The centre of the first circle", "Le centre du premier cercle" }
    /// `cone @top`
    cone_top() { "The centre of the second circle, elsewhere than the first", "Le centre du second cercle, ailleurs que le premier" }
    /// `cone @base-radius`
    base_radius() { "The radius of the first circle", "Le rayon du premier cercle" }
    /// `cone @top-radius`
    top_radius() { "The radius of the second circle; 0 makes a point of it, but not of both", "Le rayon du second cercle ; 0 en fait une pointe, mais pas des deux" }
    /// `cone @capped`
    capped() { "Whether discs close both ends, so that it encloses a volume; an open one is a sheet without thickness", "Si des disques ferment les deux bouts, de sorte qu'il enferme un volume ; ouvert, c'est une feuille sans épaisseur" }
    /// `mesh`
    mesh() { "An object made of facets, given here or in a file", "Un objet fait de facettes, données ici ou dans un fichier" }
    /// `mesh @src`
    src() { "An OBJ, PLY, STL or glTF file, relative to the document", "Un fichier OBJ, PLY, STL ou glTF, relatif au document" }
    /// `mesh @scale`
    scale() { "The factors along x, y, z; applied first", "Les facteurs selon x, y, z ; appliqués d'abord" }
    /// `mesh @rotation`
    mesh_rotation() { "Degrees about the fixed axes x, y, z in turn; applied after the scale", "Degrés autour des axes fixes x, y puis z ; appliqués après l'échelle" }
    /// `mesh @position`
    mesh_position() { "The translation, applied last", "La translation, appliquée en dernier" }
    /// `mesh @smooth`
    smooth() { "Whether light uses smooth normals", "Si la lumière emploie des normales lissées" }
    /// `vertices`
    vertices() { "The vertices of a mesh, three numbers each", "Les sommets d'un maillage, trois nombres chacun" }
    /// `normals`
    normals() { "One normal for each vertex, instead of computed ones", "Une normale par sommet, à la place de normales calculées" }
    /// `facets`
    facets() { "The facets of a mesh, three vertex numbers each, from 0", "Les facettes d'un maillage, trois numéros de sommet chacune, à partir de 0" }
    /// `part`
    part() { "A run of facets with a material of its own", "Une suite de facettes ayant sa propre matière" }
    /// `part @facets`
    part_facets() { "The first facet, from 0, and how many", "La première facette, à partir de 0, et leur nombre" }
    /// `part @material`
    part_material() { "The name of its material; a built-in grey if there is none", "Le nom de sa matière ; un gris par défaut sans elle" }
    /// `views`
    views() { "The views of a scene; the first is rendered unless another is asked for", "Les vues d'une scène ; la première est calculée, sauf demande contraire" }
    /// `view`
    view() { "A picture of the scene: an eye and a screen", "Une image de la scène : un œil et un écran" }
    /// `view @name`
    view_name() { "Its name, unique among the views", "Son nom, unique parmi les vues" }
    /// `view @width`
    width() { "The picture's width in pixels", "La largeur de l'image en pixels" }
    /// `view @height`
    height() { "The picture's height in pixels", "La hauteur de l'image en pixels" }
    /// `view @samples`
    samples() { "A pixel is the mean of so many times so many samples", "Un pixel est la moyenne d'autant de fois autant d'échantillons" }
    /// `view @depth`
    view_depth() { "The depth limit, instead of the world's", "La profondeur limite, à la place de celle du monde" }
    /// `view @without`
    without() { "The steps that are left out", "Les étapes laissées de côté" }
    /// `eye`
    eye() { "The point of view", "Le point de vue" }
    /// `eye @at`
    at() { "Where the eye is", "L'emplacement de l'œil" }
    /// `eye @look-at`
    look_at() { "The point in the middle of the picture; the screen is then derived", "Le point au milieu de l'image ; l'écran en est alors déduit" }
    /// `eye @up`, `screen @up`
    up() { "The direction that is up in the picture", "La direction du haut de l'image" }
    /// `eye @fov`
    fov() { "The horizontal field of view in degrees", "L'angle de vue horizontal en degrés" }
    /// `screen`
    screen() { "The screen, given by a corner and two edges, by its centre, or by its corners", "L'écran, donné par un coin et deux côtés, par son centre, ou par ses coins" }
    /// `screen @origin`
    screen_origin() { "The top-left corner", "Le coin supérieur gauche" }
    /// `screen @u`
    screen_u() { "The edge from there to the right", "Le côté qui en part vers la droite" }
    /// `screen @v`
    screen_v() { "The edge from there downwards", "Le côté qui en descend" }
    /// `screen @center`
    screen_center() { "Where the line of sight meets the screen at a right angle", "Le point où l'axe du regard rencontre l'écran à angle droit" }
    /// `screen @size`
    screen_size() { "Its width and height", "Sa largeur et sa hauteur" }
    /// `screen @corners`
    corners() { "Its corners: bottom left, bottom right, top right, top left", "Ses coins : bas gauche, bas droite, haut droite, haut gauche" }
}
