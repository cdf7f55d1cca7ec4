//! `lancer generate NAME [OUTPUT]`: a scene made by calculation, and its view beside it.

use crate::form::Form;
use crate::{Context, Exit, Failure, flags, target};
use clap::builder::PossibleValuesParser;
use clap::{ArgMatches, Command};
use lancer_formats::{save, xml};
use lancer_scene::Views;
use lancer_scene::generate::Family;
use lancer_words::Lang;
use lancer_words::cli::{generate as words, help};
use std::path::{Path, PathBuf};

pub(crate) fn command(lang: Lang) -> Command {
    Command::new("generate")
        .about(words::about_generate(lang))
        .after_help(words::after_generate(lang, list(lang)))
        .args([
            flags::positional("name", lang, help::name_value(lang), words::name_help(lang))
                .required(true)
                .value_parser(PossibleValuesParser::new(Family::ALL.map(Family::word)))
                .hide_possible_values(true),
            flags::path("output", lang, help::converted_value(lang), words::output_help(lang)),
        ])
        .args([flags::number("size", lang, words::size_help(lang), 0, u64::from(u32::MAX)), flags::quiet(lang)])
}

/// Every family with its sizes, one a line.
fn list(lang: Lang) -> String {
    let line = |family: Family| {
        let sizes = family.sizes();
        let range = format!("{}..{}", sizes.start(), sizes.end());
        format!("  {:<12} {range:>7} {:>5}   {}\n", family.word(), family.usual_size(), sentence(family, lang))
    };
    Family::ALL.map(line).concat()
}

fn sentence(family: Family, lang: Lang) -> String {
    match family {
        Family::Course => words::course(lang),
        Family::Sphereflake => words::sphereflake(lang),
        Family::Tetrahedron => words::tetrahedron(lang),
        Family::Mountain => words::mountain(lang),
        Family::Field => words::field(lang),
        Family::Knot => words::knot(lang),
        Family::Pebble => words::pebble(lang),
        Family::Nest => words::nest(lang),
        Family::Lattice => words::lattice(lang),
        Family::Sponge => words::sponge(lang),
    }
}

pub(crate) fn run(matches: &ArgMatches, context: &Context) -> Result<Exit, Failure> {
    let context = Context { console: context.console.quiet_if(matches.get_flag("quiet")), ..context.clone() };
    let asked = matches.get_one::<String>("name").map(String::as_str);
    let Some(family) = Family::ALL.into_iter().find(|family| Some(family.word()) == asked) else {
        // the parser lets no other name through
        return Err(Failure::Told(Exit::Usage));
    };
    let output = matches.get_one::<PathBuf>("output").cloned();
    let output = output.unwrap_or_else(|| PathBuf::from(family.word()).with_extension("xml"));
    let form = match Form::of_path(&output) {
        Some(form) => form,
        None if target::is_standard(&output) => Form::Xml,
        None => return Err(Failure::UnknownForm { path: output }),
    };
    let size = flags::number_of(matches, "size").unwrap_or(family.usual_size());
    let (scene, view) = family.generate(size).map_err(|_| Failure::BadFamilySize { family })?;
    let beside = view_beside(&output, form);
    for path in std::iter::once(&output).chain(&beside) {
        save::check(path).map_err(Failure::Save)?;
    }
    let written = form.of_scene(&scene, &output, || Ok(view.clone()))?;
    let Some(path) = &beside else { return written.save(&output, &context).map(|()| Exit::Done) };
    let views: Views = std::iter::once(view).collect();
    written.and(path, xml::write_views(&views).into_bytes()).save(&output, &context)?;
    if !context.console.quiet {
        context.console.print(words::written(context.console.lang, output.display(), path.display()) + "\n")?;
    }
    Ok(Exit::Done)
}

/// Where the view goes: beside the scene, unless that holds it itself, or nothing but objects, or goes to standard
/// output.
fn view_beside(output: &Path, form: Form) -> Option<PathBuf> {
    match form {
        Form::Xml | Form::Binary | Form::Of2009 => {
            (!target::is_standard(output)).then(|| output.with_extension("view.xml"))
        }
        Form::Povray | Form::Obj | Form::Gltf(_) => None,
    }
}
