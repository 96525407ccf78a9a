//! `bentray help`: commands and topics of the manual.

use bentray::guide::pages;

use super::Folder;

#[test]
fn help_lists_commands_and_topics() {
    let folder = Folder::new();
    let help = folder.run("help").succeeds();
    assert_eq!((help.err.as_str(), help.out.trim_end()), ("", folder.run("--help").succeeds().out.trim_end()));
    for page in pages() {
        assert!(help.out.contains(page.name), "{}", page.name);
    }
    for command in ["render", "check", "help"] {
        assert!(help.out.contains(&format!("\n  {command} ")), "{command}");
    }
}

#[test]
fn help_prints_every_page_and_the_help_of_every_command() {
    let folder = Folder::new();
    for page in pages() {
        let help = folder.run(&format!("help {}", page.name)).succeeds();
        let shown = page.shown();
        assert!(help.out.ends_with(&shown), "{}", page.name);
        // A topic that is also a command is preceded by the help of that command.
        assert_eq!(help.out == shown, page.name != "light", "{}", page.name);
        // A link is shown as a command to type, without brackets and file name.
        let prose: String = shown.split("```").step_by(2).collect();
        assert!(!prose.contains("]("), "{shown}");
    }
    assert!(folder.run("help scenes").succeeds().out.contains("`bentray help media`"));
    assert!(folder.run("help accretion").succeeds().out.contains("Luminet's disk (`bentray help luminet`)"));
    assert_eq!(folder.run("help warp-bubble").succeeds().out, folder.run("help warp_bubble").succeeds().out);
    for command in ["render", "check", "trace", "bench", "help", "formula fresnel"] {
        let help = folder.run(&format!("help {command}")).succeeds().out;
        assert_eq!(help.trim_end(), folder.run(&format!("{command} --help")).succeeds().out.trim_end());
    }
    assert!(folder.run("help light").succeeds().out.starts_with("Find the paths"));
}

#[test]
fn a_topic_that_is_none_is_answered_with_those_that_are() {
    let folder = Folder::new();
    folder.run("help scens").fails(2, &["`scens`", "use `scenes`"]);
    folder.run("help rendr").fails(2, &["use `render`"]);
    folder.run("help everything").fails(2, &["commands and topics: render, ", "scenes, ", "luminet"]);
    folder.run("help render scene").fails(2, &["`render scene`"]);
}
