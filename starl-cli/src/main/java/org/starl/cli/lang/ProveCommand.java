package org.starl.cli.lang;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.MissingDependencyException;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.OutputFile;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.lang.prove.Claim;
import org.starl.lang.prove.Interrupted;
import org.starl.lang.prove.NoSolver;
import org.starl.lang.prove.Prover;
import org.starl.lang.prove.Report;
import org.starl.lang.prove.Unprovable;
import org.starl.lang.read.Source;
import org.starl.lang.tree.Automaton;
import org.starl.lang.verdict.Verdict;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code starl prove FILE.starl}. */
@Command(
    name = "prove",
    description = {
      "Proves the invariants of automata with the solver Z3, for any number of robots where Z3 can."
          + " Prints for each invariant whether it holds, and two states and an action if an action"
          + " breaks it.",
      "Without a file, or with FILE.pvs, 'starl prove' checks proofs with an installed PVS."
    },
    footer = {"", "Example: starl prove pvs/starl/Mutex_decls.starl"})
public final class ProveCommand extends SourceCommand {

  private static final int MOST_MILLIONS = 4000;
  private static final long MILLION = 1_000_000;

  @Option(
      names = "--limit",
      paramLabel = "N",
      description =
          "Millions of Z3's steps for each obligation, about as many seconds (default:"
              + " ${DEFAULT-VALUE}). Steps, because a time would make the result depend on the"
              + " machine.")
  private String limit = "10";

  @Option(
      names = "--keep",
      paramLabel = "FOLDER",
      description = "Write each obligation as a file for Z3 (SMT-LIB 2) into this folder.")
  private @Nullable String folder;

  private long questions;

  @Override
  int run(Source source) {
    List<Automaton> automata = source.automata();
    long steps = OptionValues.whole("--limit", limit, 1, MOST_MILLIONS) * MILLION;
    Verdict verdict = Verdict.HOLDS;
    for (Automaton automaton : automata) {
      tell(automaton.name());
      Report report;
      try {
        report = prove(automaton, steps);
      } catch (OutOfMemoryError e) {
        out()
            .println(
                automaton.name()
                    + ": not decided: memory ran out; to go on, repeat it with more"
                    + " (STARL_JAVA_OPTS=-Xmx...)");
        verdict = verdict.and(Verdict.NOT_DECIDED);
        continue;
      }
      report.lines(file()).forEach(out()::println);
      places(automaton, report.actions()).forEach(out()::println);
      if (report.verdict() == Verdict.NOT_DECIDED) {
        List<String> open =
            report.claims().stream()
                .filter(each -> !each.isGood())
                .map(Claim::subject)
                .distinct()
                .toList();
        out().println(automaton.name() + ": not decided: " + String.join(", ", open));
      }
      verdict = verdict.and(report.verdict());
    }
    return ExitStatus.of(verdict);
  }

  /** What a signal prints. */
  private void tell(String automaton) {
    long asked = questions;
    stop()
        .progress(() ->
            "%d questions to Z3; %s is not decided: to go on, repeat the command"
                .formatted(asked, automaton));
  }

  private Report prove(Automaton automaton, long steps) {
    try {
      return new Prover(
              automaton,
              steps,
              (title, text) -> {
                questions++;
                tell(automaton.name());
                keep(automaton.name(), title, text);
              })
          .prove();
    } catch (Interrupted e) {
      throw stop().signalled();
    } catch (NoSolver e) {
      throw new MissingDependencyException(String.valueOf(e.getMessage()));
    } catch (Unprovable e) {
      throw new BadInput(
          file() + ":" + automaton.pos() + ": " + automaton.name() + ": " + e.getMessage());
    } catch (UncheckedIOException | InvalidPathException e) {
      throw new BadInput(
          "--keep: %s: cannot be written (%s); expected a folder"
              .formatted(BadInput.quote(String.valueOf(folder)), FailureText.of(e)));
    }
  }

  private void keep(String automaton, String title, String text) {
    if (folder != null) {
      Path path = Path.of(folder, automaton, title + ".smt2");
      try (OutputFile file = new OutputFile("--keep", path.toString())) {
        file.stream().write(text.getBytes(StandardCharsets.UTF_8));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }
}
