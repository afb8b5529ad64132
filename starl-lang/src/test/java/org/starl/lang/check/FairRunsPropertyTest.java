package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.statistics.Statistics;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

/** Progress of small random automata, against the set of states that a run visits for ever. */
class FairRunsPropertyTest {

  private static final int STATES = 5;

  /** A step between two states; {@code action} is 0 if it is not fair. */
  private record Edge(int from, int to, int action) {}

  private final List<Edge> edges = new ArrayList<>();
  private boolean[] strong = {};
  private int from;
  private int to;
  private boolean isAssumed;
  private int assumedFrom;

  @Property(tries = 300)
  void aRunIsFoundIfThereIsOne(@ForAll long seed) throws SourceErrors {
    edges.clear();
    Random random = new Random(seed);
    int actions = 1 + random.nextInt(3);
    strong = new boolean[actions + 1];
    for (int i = 1; i <= actions; i++) {
      strong[i] = random.nextBoolean();
    }
    int count = 3 + random.nextInt(8);
    for (int i = 0; i < count; i++) {
      edges.add(
          new Edge(random.nextInt(STATES), random.nextInt(STATES), random.nextInt(actions + 1)));
    }
    from = random.nextInt(1 << STATES);
    to = random.nextInt(1 << STATES) & 0b10101;
    isAssumed = random.nextInt(3) == 0;
    assumedFrom = random.nextInt(1 << STATES);
    boolean isEventually = random.nextBoolean();

    Automaton automaton = new SourceReader().read("x", source(isEventually)).getFirst();
    Sizes sizes = new Sizes(Map.of(), STATES - 1, 0);
    Search.Result result =
        new Search(new Machine(automaton, sizes), sizes, Map.of(), true, 1000).run();
    boolean hasRun = isAssumed && !hasLoop(reach(1, -1), -1);
    if (hasRun) {
      assertThat(result.unasked()).as("%d", seed).isNotEmpty();
      Statistics.collect("nothing is as assumed");
      return;
    }
    int reached = reach(1, -1);
    int first = isEventually ? 1 : reached & from;
    boolean isBroken = hasLoop(reach(first & ~to, ~to), ~to);
    assertThat(result.finding().isPresent()).as(source(isEventually)).isEqualTo(isBroken);
    Statistics.collect(isBroken ? "false" : "holds");
    result.finding().ifPresent(finding -> Statistics.collect(finding.what().contains("round")));
  }

  private String source(boolean isEventually) {
    StringBuilder text = new StringBuilder("automaton X\nstate s: nat\nstart s = 0\n");
    for (int i = 0; i < edges.size(); i++) {
      Edge edge = edges.get(i);
      String fair =
          edge.action == 0
              ? ""
              : (strong[edge.action] ? "strongly " : "") + "fair as f" + edge.action;
      text.append("action a%d %s pre s = %d eff s := %d\n".formatted(i, fair, edge.from, edge.to));
    }
    if (isAssumed) {
      text.append("assume progress A: " + in(assumedFrom) + " leads to not " + in(assumedFrom));
    }
    return text
        + "\nprogress P: "
        + (isEventually ? "eventually " : in(from) + " leads to ")
        + in(to)
        + "\n";
  }

  private static String in(int states) {
    List<String> numbers = new ArrayList<>();
    for (int i = 0; i < STATES; i++) {
      if ((states >> i & 1) == 1) {
        numbers.add("" + i);
      }
    }
    return numbers.isEmpty() ? "s != s " : "s in {" + String.join(", ", numbers) + "}";
  }

  private int reach(int first, int within) {
    int all = first & within;
    for (int i = 0; i < STATES; i++) {
      for (Edge edge : edges) {
        if ((all >> edge.from & 1) == 1) {
          all |= 1 << edge.to & within;
        }
      }
    }
    return all;
  }

  /** Whether a fair run may visit, in the end, some of these states alone, each again and again. */
  private boolean hasLoop(int reached, int within) {
    for (int set = 1; set < 1 << STATES; set++) {
      if ((set & reached & within) == set && isConnected(set) && isFair(set)) {
        return true;
      }
    }
    return false;
  }

  private boolean isConnected(int set) {
    for (int i = 0; i < STATES; i++) {
      if ((set >> i & 1) == 1 && reach(1 << i, set) != set) {
        return false;
      }
    }
    return true;
  }

  private boolean isFair(int set) {
    for (int action = 1; action < strong.length; action++) {
      int wanted = action;
      int possible = 0;
      boolean isTaken = false;
      for (Edge edge : edges) {
        if (edge.action == wanted && (set >> edge.from & 1) == 1) {
          possible |= 1 << edge.from;
          isTaken |= (set >> edge.to & 1) == 1;
        }
      }
      if (!isTaken && (strong[action] ? possible != 0 : possible == set)) {
        return false;
      }
    }
    return !isAssumed || (set & assumedFrom) == 0 || (set & ~assumedFrom) != 0;
  }
}
