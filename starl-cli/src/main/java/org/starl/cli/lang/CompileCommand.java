package org.starl.cli.lang;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.OutputFile;
import org.starl.input.BadInput;
import org.starl.lang.java.JavaSources;
import org.starl.lang.picture.ProgramPicture;
import org.starl.lang.pvs.PvsTheory;
import org.starl.lang.read.Source;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Program;
import org.starl.lang.tree.Refinement;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code starl compile}. */
@Command(
    name = "compile",
    description = {
      "Checks the automata and programs of a .starl file, and makes Java, PVS and pictures of them.",
      "Errors are printed one a line, as FILE:LINE:COLUMN: what was found; what was expected. Then no"
          + " file is written."
    },
    footer = {
      "",
      "Example: starl compile pvs/starl/Mutex_decls.starl --java starl-primitives/src/main/java",
      "         starl compile pvs/starl/Mutex_decls.starl --pvs pvs",
      "         starl compile Bridge.starl --java src/main/java --svg bridge.svg"
    })
public final class CompileCommand extends SourceCommand {

  @Option(
      names = "--java",
      paramLabel = "FOLDER",
      description =
          "Write each program, and the executable form of each automaton and its actions, below this"
              + " folder of Java sources: the classes that the source names.")
  private @Nullable String java;

  @Option(
      names = "--pvs",
      paramLabel = "FOLDER",
      description = "Write the theory of each automaton, NAME.pvs, into this folder.")
  private @Nullable String pvs;

  @Option(
      names = "--svg",
      paramLabel = "FILE.svg",
      description = "Write a picture of the program: its locations and branches.")
  private @Nullable String svg;

  @Override
  int run(Source source) throws IOException {
    List<Automaton> automata = source.automata();
    Map<String, String> pictures = new TreeMap<>();
    if (svg != null) {
      pictures.put(svg, ProgramPicture.of(onlyProgram(source)));
    }
    Map<String, String> classes = new TreeMap<>();
    Map<String, String> theories = new TreeMap<>();
    try {
      if (java != null) {
        classes.putAll(JavaSources.of(source, file()));
      }
      for (Automaton automaton : automata) {
        if (pvs != null) {
          Path path = Path.of(pvs).toAbsolutePath().relativize(Path.of(file()).toAbsolutePath());
          String shown = path.toString().replace(File.separatorChar, '/');
          theories.put(automaton.name() + ".pvs", PvsTheory.of(automaton, shown));
        }
      }
    } catch (SourceErrors e) {
      e.errors().forEach(err()::println);
      return ExitStatus.BAD_INPUT;
    } catch (IllegalArgumentException e) {
      throw new BadInput(file() + ": " + e.getMessage());
    }
    for (Automaton each : automata) {
      out().println(each.name() + ": " + each.actions().size() + " actions");
      List<String> left = new ArrayList<>();
      each.claims().forEach(name -> left.add("progress " + name));
      each.constraints().forEach(constraint -> left.add("constraint " + constraint.name()));
      if (!left.isEmpty() && (java != null || pvs != null)) {
        String names = String.join(", ", left);
        out().println(each.name() + ": not in Java and PVS, see 'starl check': " + names);
      }
      for (Refinement refinement : java == null ? List.<Refinement>of() : each.refinements()) {
        out().println(each.name() + ": not in Java, see 'starl check': " + refinement.title());
      }
    }
    write("--java", java, classes);
    write("--pvs", pvs, theories);
    write("--svg", "", pictures);
    return ExitStatus.GOOD;
  }

  private Program onlyProgram(Source source) {
    if (source.programs().size() != 1) {
      throw new BadInput(
          "--svg: " + file() + " has " + source.programs().size() + " programs; expected one");
    }
    return source.programs().getFirst();
  }

  private void write(String option, @Nullable String folder, Map<String, String> files)
      throws IOException {
    for (Map.Entry<String, String> each : files.entrySet()) {
      Path path = Path.of(String.valueOf(folder)).resolve(each.getKey());
      try (OutputFile output = new OutputFile(option, path.toString())) {
        output.stream().write(each.getValue().getBytes(StandardCharsets.UTF_8));
      }
      out().println(path);
    }
  }
}
