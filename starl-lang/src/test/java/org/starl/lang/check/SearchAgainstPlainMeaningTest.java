package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Label;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;
import net.jqwik.api.Tag;
import net.jqwik.api.statistics.Statistics;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Row;
import org.starl.lang.eval.Sizes;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Type.Field;

class SearchAgainstPlainMeaningTest {

  private static final int NAT = 2;

  /** A second search, without symmetry, on plain values. */
  private static final class PlainSearch {

    final PlainMeaning meaning;
    final Automaton automaton;
    final Set<Map<String, Object>> states = new LinkedHashSet<>();
    long steps;
    long beyond;
    int outside;

    /** The depth at which something is wrong; a step that has no value counts as taken. */
    Optional<Integer> wrongAt = Optional.empty();

    PlainSearch(Automaton automaton, List<String> ids) {
      this.automaton = automaton;
      meaning = new PlainMeaning(automaton, ids, NAT);
      Set<Map<String, Object>> level = new LinkedHashSet<>();
      starts(ids).forEach(start -> visit(start, level, 0));
      for (int depth = 1; !level.isEmpty() && wrongAt.isEmpty(); depth++) {
        Set<Map<String, Object>> next = new LinkedHashSet<>();
        for (Map<String, Object> state : level) {
          for (Action action : automaton.actions()) {
            List<Map<String, Object>> all = new ArrayList<>(List.of(Map.of()));
            for (Field parameter : action.parameters()) {
              all = extended(all, parameter, meaning.values(parameter.type()));
            }
            for (Map<String, Object> arguments : all) {
              take(action, state, arguments, next, depth);
            }
          }
        }
        level.clear();
        level.addAll(next);
      }
    }

    private static List<Map<String, Object>> extended(
        List<Map<String, Object>> all, Field parameter, List<?> values) {
      List<Map<String, Object>> more = new ArrayList<>();
      for (Map<String, Object> each : all) {
        values.forEach(value -> more.add(PlainMeaning.with(each, parameter, value)));
      }
      return more;
    }

    private void take(
        Action action,
        Map<String, Object> state,
        Map<String, Object> arguments,
        Set<Map<String, Object>> next,
        int depth) {
      try {
        if (!meaning.enabled(action, state, arguments)) {
          return;
        }
        Optional<Map<String, Object>> after = meaning.after(action, state, arguments);
        if (after.isEmpty()) {
          beyond++;
          return;
        }
        steps++;
        visit(after.get(), next, depth);
      } catch (PlainMeaning.Undefined e) {
        wrongAt = Optional.of(depth);
      }
    }

    private void visit(Map<String, Object> state, Set<Map<String, Object>> level, int depth) {
      if (!states.add(state)) {
        return;
      }
      boolean holds;
      try {
        holds = meaning.holds(state);
        if (meaning.isWithin(state)) {
          level.add(state);
        } else {
          outside++;
        }
      } catch (PlainMeaning.Undefined e) {
        holds = false;
      }
      if (!holds) {
        wrongAt = Optional.of(depth);
      }
    }

    private List<Map<String, Object>> starts(List<String> ids) {
      String start = automaton.start().toString();
      Map<Object, Object> empty = new TreeMap<>();
      ids.forEach(id -> empty.put(id, new TreeSet<>()));
      List<Object> options = new ArrayList<>(List.of(Optional.empty()));
      if (!start.contains("name=o,")) {
        ids.forEach(id -> options.add(Optional.of(id)));
      }
      List<Set<String>> sets = new ArrayList<>(List.of(new TreeSet<>()));
      if (!start.contains("name=s,")) {
        for (String id : ids) {
          for (Set<String> set : List.copyOf(sets)) {
            Set<String> larger = new TreeSet<>(set);
            larger.add(id);
            sets.add(larger);
          }
        }
      }
      List<Map<String, Object>> all = new ArrayList<>();
      for (Set<String> set : sets) {
        for (Object option : options) {
          Map<String, Object> state = new LinkedHashMap<>();
          state.put("s", set);
          state.put("n", 0);
          state.put("o", option);
          state.put("m", empty);
          state.put("l", List.of());
          state.put("z", 0);
          all.add(state);
        }
      }
      return all;
    }

    Set<String> texts() {
      Set<String> texts = new TreeSet<>();
      states.forEach(state -> texts.add(text(state)));
      return texts;
    }

    private static String text(Map<String, Object> state) {
      return String.join("; ", state.values().stream().map(PlainMeaning::text).toList());
    }

    /** For each state, the first of the texts that it has under other names. */
    Set<String> orbits(List<String> ids) {
      Set<String> orbits = new TreeSet<>();
      for (Map<String, Object> state : states) {
        TreeSet<String> texts = new TreeSet<>();
        for (List<String> order : orders(ids)) {
          Map<String, String> names = new LinkedHashMap<>();
          ids.forEach(id -> names.put(id, order.get(ids.indexOf(id))));
          Map<String, Object> renamed = new LinkedHashMap<>();
          state.forEach((name, value) -> renamed.put(name, meaning.renamed(value, names)));
          texts.add(text(renamed));
        }
        orbits.add(texts.first());
      }
      return orbits;
    }

    private static List<List<String>> orders(List<String> ids) {
      if (ids.isEmpty()) {
        return List.of(List.of());
      }
      List<List<String>> all = new ArrayList<>();
      for (String first : ids) {
        List<String> rest = new ArrayList<>(ids);
        rest.remove(first);
        for (List<String> order : orders(rest)) {
          List<String> longer = new ArrayList<>(List.of(first));
          longer.addAll(order);
          all.add(longer);
        }
      }
      return all;
    }
  }

  @Property(tries = 300, shrinking = ShrinkingMode.OFF)
  @Label("a search visits the states that a plain one visits, with symmetry one of each orbit")
  @Tag("long")
  void searchVisitsTheStatesOfAPlainOne(@ForAll long seed) throws SourceErrors {
    String source = new RandomAutomaton(new java.util.Random(seed)).constrained();
    Automaton automaton = new SourceReader().read("random.starl", source).getFirst();
    List<String> ids = seed % 2 == 0 ? List.of("bot0", "bot1") : List.of("bot0", "bot1", "bot2");
    PlainSearch plain = new PlainSearch(automaton, ids);
    Sizes sizes = new Sizes(Map.of("PIDS", ids.size()), NAT, NAT);
    Machine machine = new Machine(automaton, sizes);
    Search all = new Search(machine, sizes, Map.of(), false, 1_000_000);
    Search symmetric = new Search(machine, sizes, Map.of(), true, 1_000_000);
    Search.Result found = all.run();
    Search.Result foundSymmetric = symmetric.run();
    Statistics.label("wrong").collect(plain.wrongAt.isPresent());
    Statistics.label("states").collect(plain.states.size() > 50);
    Statistics.label("outside").collect(plain.outside > 0);

    assertThat(wrongAt(found)).as(source).isEqualTo(plain.wrongAt);
    assertThat(wrongAt(foundSymmetric)).as(source).isEqualTo(plain.wrongAt);
    if (plain.wrongAt.isEmpty()) {
      assertThat(texts(machine, all)).as(source).isEqualTo(plain.texts());
      assertThat(found.steps()).as(source).isEqualTo(plain.steps);
      assertThat(found.outside()).as(source).isEqualTo(plain.outside);
      assertThat(found.beyond()).as(source).isEqualTo(plain.beyond);
      assertThat(symmetric.visited()).as(source).hasSize(plain.orbits(ids).size());
      assertThat(plain.texts()).as(source).containsAll(texts(machine, symmetric));
      assertThat(foundSymmetric.depth()).as(source).isEqualTo(found.depth());
      assertThat(foundSymmetric.never()).as(source).isEqualTo(found.never());
      assertThat(foundSymmetric.neverFalse()).as(source).isEqualTo(found.neverFalse());
    }
  }

  private static Optional<Integer> wrongAt(Search.Result result) {
    return result.finding().map(finding -> finding.steps() + (finding.name().isEmpty() ? 1 : 0));
  }

  private static Set<String> texts(Machine machine, Search search) {
    Set<String> texts = new TreeSet<>();
    for (Row state : search.visited()) {
      List<String> parts = new ArrayList<>();
      for (int i = 0; i < machine.parts().size(); i++) {
        parts.add(machine.parts().get(i).domain().text(state.get(i)));
      }
      texts.add(String.join("; ", parts));
    }
    return texts;
  }
}
