package org.starl.cli.lang;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.Version;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.ProgressLine;
import org.starl.input.BadInput;
import org.starl.lang.check.Report;
import org.starl.lang.check.Search;
import org.starl.lang.eval.Beyond;
import org.starl.lang.eval.EvalError;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.eval.TooLarge;
import org.starl.lang.read.Source;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Type.Field;
import org.starl.lang.verdict.Verdict;
import org.starl.time.Time;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code starl check}. */
@Command(
    name = "check",
    description = {
      "Visits all states of the automata in a source at small sizes, and checks the invariants in"
          + " each. Prints a shortest run to the first state where one is false.",
      "Then checks progress ('eventually', 'leads to', 'no deadlock') in all fair runs. Prints a run in"
          + " which it does not happen: the steps that come round for ever, and the fair actions"
          + " taken there."
    },
    footer = {
      "",
      "Example: starl check pvs/starl/Mutex_decls.starl --robots 3 --size Zones=2",
      "         starl check pvs/starl/Barrier_decls.starl --value 'first={bot0, bot1}'"
    })
public final class CheckCommand extends SourceCommand {

  private static final int USUAL_SIZE = 2;
  private static final int LARGEST = 62;
  private static final int LARGEST_NUMBER = 1000;
  private static final int MOST_STATES = 100_000_000;

  @Option(
      names = "--robots",
      paramLabel = "N",
      description = "Elements of the first opaque type (default: ${DEFAULT-VALUE}).")
  private String robots = "3";

  @Option(
      names = "--size",
      paramLabel = "TYPE=N",
      description = "Elements of another opaque type (default: 2). May be repeated.")
  private List<String> sizes = new ArrayList<>();

  @Option(
      names = "--nat",
      paramLabel = "N",
      description =
          "The largest natural number and int, of which -N is the least, and the largest length of"
              + " a list (default: ${DEFAULT-VALUE}). Steps beyond it are not taken.")
  private String nat = "2";

  @Option(
      names = "--time",
      paramLabel = "N",
      description =
          "The largest time (default: ${DEFAULT-VALUE}). Where any time may be chosen, whole numbers"
              + " are.")
  private String time = "2";

  @Option(
      names = "--value",
      paramLabel = "NAME=VALUE",
      description =
          "The value of a value parameter (default: each value is tried). Elements of the first"
              + " opaque type are bot0, bot1 and so on; of the second A, B; of type T, T0, T1. May"
              + " be repeated.")
  private List<String> values = new ArrayList<>();

  @Option(
      names = "--no-symmetry",
      description = "Visit also states that differ in the names of elements alone.")
  private boolean hasNoSymmetry;

  @Option(
      names = "--most",
      paramLabel = "N",
      description = "The largest number of states (default: ${DEFAULT-VALUE}).")
  private String most = "5000000";

  @Option(
      names = "--checkpoint",
      paramLabel = "FILE",
      description =
          "Where a search that ends early (Ctrl-C, --most, memory) is saved; --resume goes on from"
              + " there.")
  private @Nullable String checkpoint;

  @Option(
      names = "--resume",
      description = "Go on with the search in --checkpoint FILE, if there is one.")
  private boolean isResumed;

  // The two options, by their names.
  private Map<String, String> sizeOf = Map.of();
  private Map<String, String> valueOf = Map.of();

  @Override
  int run(Source source) throws IOException {
    List<Automaton> automata = source.automata();
    sizeOf = OptionValues.named("--size", sizes, "TYPE=N");
    valueOf = OptionValues.named("--value", values, "NAME=VALUE");
    if (isResumed && checkpoint == null) {
      throw new BadInput("--resume needs --checkpoint FILE");
    }
    if (checkpoint != null) {
      requireOneSearch(automata);
    }
    Verdict verdict = Verdict.HOLDS;
    stop().endsWhenAsked();
    for (Automaton automaton : automata) {
      if (!stop().isStopped()) {
        verdict = verdict.and(check(automaton, automata));
      }
    }
    return ExitStatus.of(verdict);
  }

  private void requireOneSearch(List<Automaton> automata) {
    int searches = automata.stream().mapToInt(each -> allSizes(each, automata).size()).sum();
    if (searches != 1) {
      throw new BadInput(
          "--checkpoint: %s has %d searches, one for each automaton and value of sizes; expected one"
              .formatted(file(), searches));
    }
  }

  private List<Sizes> allSizes(Automaton automaton, List<Automaton> automata) {
    return Machine.sizes(automaton, sizes(automaton, automata), numbers(automaton));
  }

  private Verdict check(Automaton automaton, List<Automaton> automata) throws IOException {
    List<Sizes> all = allSizes(automaton, automata);
    if (all.isEmpty()) {
      String cure =
          automaton.refined().numbers().stream()
              .map(name -> "--value " + name + "=...")
              .collect(Collectors.joining(" "));
      out()
          .println(
              "%s: not decided: no numbers to --nat %d meet the assumptions; give larger ones: %s"
                  .formatted(automaton.name(), sizes(automaton, automata).nat(), cure));
      return Verdict.NOT_DECIDED;
    }
    Verdict verdict = Verdict.HOLDS;
    for (Sizes each : all) {
      if (!stop().isStopped()) {
        verdict = verdict.and(check(automaton, automata, each));
      }
    }
    return verdict;
  }

  private Verdict check(Automaton automaton, List<Automaton> automata, Sizes of)
      throws IOException {
    int limit = OptionValues.whole("--most", most, 1, MOST_STATES);
    Search search;
    Machine machine = null;
    try {
      machine = new Machine(automaton, of);
      search = new Search(machine, of, values(machine, of, automata), !hasNoSymmetry, limit);
    } catch (TooLarge e) {
      throw new BadInput(file() + ": " + automaton.name() + ": " + e.getMessage());
    } catch (EvalError e) {
      String message = file(e.automaton(), automata) + ":" + e.pos() + ": " + e.getMessage();
      if (machine == null) {
        throw new BadInput(message);
      }
      out().println(Report.head(automaton, of, Set.of()) + ": the start is undefined");
      out().println("  " + message);
      return Verdict.VIOLATED;
    } catch (OutOfMemoryError e) {
      out().println(automaton.name() + ": not decided: memory ran out before the first state");
      return Verdict.NOT_DECIDED;
    }
    if (checkpoint == null) {
      return run(automaton, automata, of, search, null);
    }
    try (SavedSearch saved = new SavedSearch(checkpoint, key(automaton, of), isResumed, err())) {
      saved.of(search);
      return run(automaton, automata, of, search, saved);
    }
  }

  private Verdict run(
      Automaton automaton,
      List<Automaton> automata,
      Sizes of,
      Search search,
      @Nullable SavedSearch saved)
      throws IOException {
    ProgressLine clock = new ProgressLine(err(), "states");
    Search.Result result =
        search.run(() -> {
          clock.found(search.size(), search.size() - search.next());
          return stop().isStopped();
        });
    clock.end();
    double seconds = Time.seconds(clock.elapsedNs());
    Report.lines(automaton, of, result, at -> file(at, automata)).forEach(out()::println);
    result.finding().ifPresent(found -> places(automaton, found.actions()).forEach(out()::println));
    if (saved != null && !result.stopped().isEmpty()) {
      saved.save();
    }
    err().println("%.1f s, %,.0f states a second".formatted(seconds, result.states() / seconds));
    return result.verdict();
  }

  /** What decides which states are visited, in which order. */
  private String key(Automaton automaton, Sizes of) {
    return "%s, --nat %d, --time %d%s%s, StarL %s, source %s"
        .formatted(
            Report.head(automaton, of, Set.of()),
            of.nat(),
            of.time(),
            values.stream().sorted().map(each -> ", --value " + each).collect(Collectors.joining()),
            hasNoSymmetry ? ", --no-symmetry" : "",
            Version.STARL,
            digest());
  }

  /** An automaton that is not in the file was found beside it, or is StarL's. */
  private String file(String automaton, List<Automaton> automata) {
    if (automata.stream().anyMatch(a -> a.name().equals(automaton))) {
      return file();
    }
    Path beside = Path.of(file()).resolveSibling(automaton + ".starl");
    return Files.exists(beside) ? beside.toString() : "pvs/starl/" + automaton + ".starl";
  }

  private Sizes sizes(Automaton automaton, List<Automaton> automata) {
    Map<String, Integer> opaque = new LinkedHashMap<>();
    int first = OptionValues.whole("--robots", robots, 1, LARGEST);
    for (String type : Machine.opaqueTypes(automaton)) {
      opaque.put(type, opaque.isEmpty() ? first : USUAL_SIZE);
    }
    sizeOf.forEach((type, size) -> {
      if (automata.stream().noneMatch(a -> Machine.opaqueTypes(a).contains(type))) {
        boolean isValue =
            automata.stream()
                .flatMap(a -> a.valueParameters().stream())
                .anyMatch(p -> p.name().equals(type));
        throw new BadInput(
            "--size: "
                + BadInput.quote(type)
                + " is no opaque type here; expected "
                + (isValue
                    ? "--value " + type + "=" + size
                    : oneOf(opaque.keySet(), String.join(", ", opaque.keySet()))));
      }
      int number = OptionValues.whole("--size", size, 1, LARGEST);
      opaque.computeIfPresent(type, (key, usual) -> number);
    });
    return new Sizes(
        opaque,
        OptionValues.whole("--nat", nat, 0, LARGEST_NUMBER),
        OptionValues.whole("--time", time, 0, LARGEST_NUMBER));
  }

  private static String oneOf(Collection<String> names, String those) {
    return names.isEmpty() ? "no such option, as there is none" : "one of " + those;
  }

  /** The values that are given for parameters in bounds of ranges. */
  private Map<String, Integer> numbers(Automaton automaton) {
    Map<String, Integer> given = new LinkedHashMap<>();
    valueOf.forEach((parameter, text) -> {
      if (automaton.refined().numbers().contains(parameter)) {
        given.put(
            parameter, OptionValues.whole("--value " + parameter, text.strip(), 0, LARGEST_NUMBER));
      }
    });
    return given;
  }

  private Map<String, Object> values(Machine machine, Sizes of, List<Automaton> automata) {
    Map<String, Object> given = new LinkedHashMap<>();
    for (Map.Entry<String, String> each : valueOf.entrySet()) {
      String parameter = each.getKey();
      boolean isOfAnother =
          machine.parameters().stream().noneMatch(p -> p.name().equals(parameter))
              && automata.stream()
                  .flatMap(a -> a.valueParameters().stream())
                  .anyMatch(p -> p.name().equals(parameter));
      if (isOfAnother || of.numbers().containsKey(parameter)) {
        continue;
      }
      List<String> names = machine.parameters().stream().map(Field::name).toList();
      Field field =
          machine.parameters().stream()
              .filter(p -> p.name().equals(parameter))
              .findFirst()
              .orElseThrow(() ->
                  new BadInput(
                      "--value: %s is no value parameter of %s; expected %s"
                          .formatted(
                              BadInput.quote(parameter),
                              machine.automaton().name(),
                              oneOf(names, names.toString()))));
      String text = each.getValue();
      try {
        Expr expr =
            SourceReader.readExpression(
                machine.automaton(),
                machine.elements(),
                field.type(),
                "--value " + parameter,
                text);
        given.put(parameter, machine.value(expr));
      } catch (SourceErrors e) {
        throw new BadInput(e.errors().getFirst().toString());
      } catch (EvalError e) {
        throw new BadInput("--value " + parameter + ":" + e.pos() + ": " + e.getMessage());
      } catch (Beyond e) {
        throw new BadInput(
            "--value %s: %s is beyond the bounds; expected larger --nat or --time"
                .formatted(parameter, BadInput.quote(text)));
      }
    }
    return given;
  }
}
