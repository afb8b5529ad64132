package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.starl.input.BadInput;
import org.starl.input.NearMatches;

/**
 * The grammar of faults: {@code name(arguments,times)}. The affected robots come first: a name,
 * {@code bot0+bot1}, {@code any} (drawn by seed), {@code half} or {@code all}.
 */
public final class FaultGrammar {

  /** The times of every fault, one line for users. */
  public static final String TIMES =
      "every fault takes at=12s or at=5s..20s (drawn), and for=5s, for=2s..9s or until=30s";

  /**
   * One kind of fault, for users.
   *
   * @param usage its syntax
   * @param meaning one line
   */
  public record Kind(String name, String usage, String meaning) {}

  /**
   * A kind of fault and its implementation.
   *
   * @param reader reads the arguments after the robots, in canonical order
   */
  record Row(Kind kind, Function<FaultArguments, FaultAction> reader) {

    static Row row(String usage, String meaning, Function<FaultArguments, FaultAction> reader) {
      int open = usage.indexOf('(');
      String name = open < 0 ? usage : usage.substring(0, open);
      return new Row(new Kind(name, usage, meaning), reader);
    }
  }

  private static final List<Row> ROWS = new ArrayList<>();

  static {
    ROWS.add(RobotFaults.CRASH);
    ROWS.addAll(NetworkFaults.ROWS);
    ROWS.addAll(RobotFaults.ROWS);
  }

  private FaultGrammar() {}

  /** Every kind of fault, in display order. */
  public static List<Kind> kinds() {
    return ROWS.stream().map(Row::kind).toList();
  }

  /**
   * Reads one fault.
   *
   * @throws BadInput if the text is not a fault; the message has the text, the argument and what
   *     was expected
   */
  public static Fault parse(String text) {
    FaultArguments call = FaultArguments.parse(text);
    Row row = rowOf(call);
    call.usage(row.kind.usage());
    if (row.kind.usage().contains("(WHO")) {
      call.readRobots();
    }
    FaultEffect effect = call.effect(row.reader.apply(call));
    Span span = Span.read(call, effect.lastingKey());
    call.end();
    return new Fault(effect, span);
  }

  private static Row rowOf(FaultArguments call) {
    List<String> names = new ArrayList<>();
    for (Row row : ROWS) {
      if (row.kind.name().equals(call.name())) {
        return row;
      }
      names.add(row.kind.name());
    }
    throw call.bad(
        "no fault is called " + BadInput.quote(call.name()) + NearMatches.hint(call.name(), names));
  }
}
