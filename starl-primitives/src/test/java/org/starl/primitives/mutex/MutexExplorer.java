package org.starl.primitives.mutex;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexProtocol.Phase;

/**
 * Explores every behaviour of a few participants breadth first, as the model checker explores the
 * model. Messages stay in a set for ever, which covers loss, delay, duplication and reordering.
 * Timers are choices without a clock: what a timer may do, it may do at any time. A repeated request
 * is in the set already, an expired one is a withdrawal, a silent participant is suspected.
 * Protocols cannot be copied, so a state is reached again by replaying its path.
 */
final class MutexExplorer {

  /**
   * The instance to explore.
   *
   * @param views the initial views; the members of the first one know it, and participants of a
   *     later one learn that view first. Confinements add views
   * @param wants the sets of sections that may be requested
   * @param requests the largest number of requests by one participant
   * @param suspicions the largest number of suspicions
   * @param crashes the largest number of participants that crash and do not come back; their robots
   *     stay in the sections that they hold
   */
  record Shape(
      List<View> views,
      List<List<String>> wants,
      int requests,
      boolean withdrawals,
      int suspicions,
      int crashes) {

    Shape(
        List<View> views,
        List<List<String>> wants,
        int requests,
        boolean withdrawals,
        int suspicions) {
      this(views, wants, requests, withdrawals, suspicions, 0);
    }
  }

  /** The result: the first violation with the steps to it, or none. */
  record Outcome(int states, int entries, List<String> violation) {}

  private final Shape shape;
  private final MutexNode.Kind kind;

  MutexExplorer(Shape shape, MutexNode.Kind kind) {
    this.shape = shape;
    this.kind = kind;
  }

  Outcome explore(int mostStates) {
    Set<String> seen = new HashSet<>();
    ArrayDeque<List<Integer>> frontier = new ArrayDeque<>();
    frontier.add(List.of());
    seen.add(new Situation().key());
    int entries = 0;
    while (!frontier.isEmpty()) {
      List<Integer> path = frontier.remove();
      int choices = at(path).choices().size();
      for (int choice = 0; choice < choices; choice++) {
        Situation next = at(path);
        next.take(choice);
        if (!seen.add(next.key())) {
          continue;
        }
        if (seen.size() > mostStates) {
          throw new AssertionError("more than " + mostStates + " states");
        }
        List<Integer> longer = new ArrayList<>(path);
        longer.add(choice);
        entries += next.nodes.stream().anyMatch(node -> node.isIn(Phase.CRITICAL)) ? 1 : 0;
        var violation = MutexOracle.violation("", next.nodes, next.lastView());
        if (violation.isPresent()) {
          next.story.add(violation.get());
          return new Outcome(seen.size(), entries, next.story);
        }
        frontier.add(longer);
      }
    }
    return new Outcome(seen.size(), entries, List.of());
  }

  private Situation at(List<Integer> path) {
    Situation situation = new Situation();
    for (int choice : path) {
      situation.take(choice);
    }
    return situation;
  }

  private final class Situation {
    final List<MutexNode> nodes = new ArrayList<>();
    final List<String> story = new ArrayList<>();
    private final Map<String, MutexMessage> messages = new LinkedHashMap<>();
    private final List<View> learned = new ArrayList<>();
    private final List<View> views = new ArrayList<>(shape.views());
    private int suspicions;
    private int crashes;

    Situation() {
      for (ProcessId id : lastView().ids()) {
        nodes.add(new MutexNode(id, kind, m -> messages.putIfAbsent(m.toString(), m), e -> {}));
        learned.add(View.NONE);
      }
      for (int i = 0; i < nodes.size(); i++) {
        if (shape.views().get(0).contains(nodes.get(i).id)) {
          learn(i, shape.views().get(0));
        }
      }
      story.clear();
    }

    View lastView() {
      return views.get(views.size() - 1);
    }

    void take(int choice) {
      choices().get(choice).run();
    }

    /** All possible next steps. The same path gives the same choices in the same order. */
    List<Runnable> choices() {
      List<Runnable> all = new ArrayList<>();
      for (int i = 0; i < nodes.size(); i++) {
        if (!nodes.get(i).dead) {
          addChoices(i, all);
        }
      }
      messages.forEach((text, message) -> {
        for (MutexNode node : nodes) {
          if (node.id.equals(message.to()) && !node.dead) {
            all.add(step(text, () -> node.protocol.receive(message, 0)));
          }
        }
      });
      return all;
    }

    private void addChoices(int i, List<Runnable> all) {
      MutexNode node = nodes.get(i);
      if (node.isIn(Phase.IDLE) && node.protocol.mayRequest() && node.num < shape.requests()) {
        for (List<String> want : shape.wants()) {
          all.add(
              step(
                  node.id + " requests " + want,
                  () -> node.protocol.request(Sections.copyOf(want), 0)));
        }
      }
      if (node.isIn(Phase.TRYING) && shape.withdrawals()) {
        all.add(step(node.id + " withdraws", () -> node.protocol.withdraw(MutexFailure.WITHDRAWN)));
      }
      if (node.isIn(Phase.CRITICAL)) {
        for (String section : node.protocol.held()) {
          all.add(
              step(
                  node.id + " releases " + section,
                  () -> node.protocol.release(new TreeSet<>(List.of(section)))));
        }
      }
      if (node.isIn(Phase.TRYING) && suspicions < shape.suspicions()) {
        for (ProcessId other : node.protocol.missing()) {
          all.add(
              step(
                  node.id + " suspects " + other,
                  () -> {
                    suspicions++;
                    node.protocol.suspect(other, 0);
                  }));
        }
      }
      if (crashes < shape.crashes()) {
        all.add(
            step(
                node.id + " crashes",
                () -> {
                  crashes++;
                  node.diesHolding();
                }));
      }
      for (Confinement each : node.proposed) {
        if (each.changes(lastView()) && each.hasFencersIn(lastView())) {
          all.add(step(each.toString(), () -> views.add(each.applyTo(lastView().next()))));
        }
      }
      for (View view : List.copyOf(views)) {
        boolean isOut = learned.get(i).equals(View.NONE) && !view.contains(node.id);
        if (view.number() > learned.get(i).number() && !isOut) {
          all.add(() -> learn(i, view));
        }
      }
    }

    private Runnable step(String line, Runnable action) {
      return () -> {
        story.add(line);
        action.run();
      };
    }

    private void learn(int i, View view) {
      story.add(nodes.get(i).id + " learns view " + view.number());
      learned.set(i, view);
      nodes.get(i).protocol.learn(view);
    }

    private TreeSet<String> sorted(Set<Confinement> confinements) {
      TreeSet<String> texts = new TreeSet<>();
      confinements.forEach(each -> texts.add(each.toString()));
      return texts;
    }

    String key() {
      StringBuilder text = new StringBuilder();
      nodes.forEach(node ->
          text.append(node.protocol.state())
              .append(node.consentedTo)
              .append(sorted(node.proposed))
              .append(node.dead ? "dead" : "")
              .append('|'));
      text.append(views).append(suspicions);
      return text.append(new TreeSet<>(messages.keySet())).toString();
    }
  }
}
