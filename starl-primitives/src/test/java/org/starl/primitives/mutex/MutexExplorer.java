package org.starl.primitives.mutex;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
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
 *
 * <p>A participant depends on the others only through messages and views. So the protocol runs once
 * for each state of one participant and each step of it ({@link Local}); states of all participants
 * are tuples of these.
 */
final class MutexExplorer {

  /**
   * The instance to explore.
   *
   * @param views the initial views; the members of the first one know it, and participants of a
   *     later one learn that view first. Confinements add views
   * @param wants the sets of sections that may be requested
   * @param requests the largest number of requests by one participant
   * @param requesters the first participants, which request; the others only answer
   * @param suspicions the largest number of suspicions
   * @param crashes the largest number of participants that crash and do not come back; their robots
   *     stay in the sections that they hold
   */
  record Shape(
      List<View> views,
      List<List<String>> wants,
      int requests,
      int requesters,
      boolean withdrawals,
      int suspicions,
      int crashes) {

    /** All participants request, and none crashes. */
    Shape(
        List<View> views,
        List<List<String>> wants,
        int requests,
        boolean withdrawals,
        int suspicions) {
      this(views, wants, requests, Integer.MAX_VALUE, withdrawals, suspicions, 0);
    }
  }

  /** The result: the first violation with the steps to it, or none. */
  record Outcome(int states, int entries, List<String> violation) {}

  private final Shape shape;
  private final MutexNode.Kind kind;
  private final Map<String, Local> locals = new HashMap<>();
  private final List<MutexMessage> messages = new ArrayList<>();
  private final Map<String, Integer> messageNumbers = new HashMap<>();

  MutexExplorer(Shape shape, MutexNode.Kind kind) {
    this.shape = shape;
    this.kind = kind;
  }

  Outcome explore(int mostStates) {
    Set<String> seen = new HashSet<>();
    ArrayDeque<State> frontier = new ArrayDeque<>();
    State first = first();
    seen.add(first.key());
    frontier.add(first);
    int entries = 0;
    while (!frontier.isEmpty()) {
      State state = frontier.remove();
      for (State next : state.next()) {
        if (!seen.add(next.key())) {
          continue;
        }
        if (seen.size() > mostStates) {
          throw new AssertionError("more than " + mostStates + " states");
        }
        List<MutexNode> nodes = next.locals.stream().map(local -> local.node).toList();
        entries += nodes.stream().anyMatch(node -> node.isIn(Phase.CRITICAL)) ? 1 : 0;
        var violation = MutexOracle.violation("", nodes, next.lastView());
        if (violation.isPresent()) {
          return new Outcome(seen.size(), entries, next.story(violation.get()));
        }
        frontier.add(next);
      }
    }
    return new Outcome(seen.size(), entries, List.of());
  }

  private State first() {
    List<Local> nodes = new ArrayList<>();
    BitSet sent = new BitSet();
    View known = shape.views().get(0);
    for (ProcessId id : shape.views().get(shape.views().size() - 1).ids()) {
      Local local = local(id, List.of(), View.NONE, new ArrayList<>());
      Reached begun = known.contains(id) ? local.after(learns(local, known)) : null;
      nodes.add(begun == null ? local : begun.local());
      if (begun != null) {
        sent.or(begun.sent());
      }
    }
    return new State(nodes, sent, shape.views(), 0, 0, null, "");
  }

  /** Something that one participant does. {@code line} identifies it. */
  private record Step(String line, View learned, Consumer<MutexNode> action) {}

  /** The state of a participant after a step, and the messages that the step sent. */
  private record Reached(Local local, BitSet sent) {}

  /** The participant after {@code steps}, which may be as after fewer or other ones. */
  private Local local(ProcessId id, List<Step> steps, View learned, List<MutexMessage> sent) {
    MutexNode node = new MutexNode(id, kind, sent::add, e -> {});
    for (Step step : steps) {
      sent.clear();
      step.action().accept(node);
    }
    Local local = new Local(node, steps, learned, locals.size());
    return locals.computeIfAbsent(local.text(), any -> local);
  }

  private Step learns(Local local, View view) {
    return new Step(
        local.node.id + " learns view " + view, view, node -> node.protocol.learn(view));
  }

  private int number(MutexMessage message) {
    return messageNumbers.computeIfAbsent(
        message.toString(),
        text -> {
          messages.add(message);
          return messages.size() - 1;
        });
  }

  /** A state of one participant, reached by steps of its own. */
  private final class Local {
    final MutexNode node;
    final View learned;
    final int number;
    private final List<Step> steps;
    private final Map<String, Reached> after = new HashMap<>();

    Local(MutexNode node, List<Step> steps, View learned, int number) {
      this.node = node;
      this.steps = steps;
      this.learned = learned;
      this.number = number;
    }

    String text() {
      TreeSet<String> proposed = new TreeSet<>();
      node.proposed.forEach(each -> proposed.add(each.toString()));
      return node.id
          + (node.dead ? " dead in " + node.bodyIn : " ")
          + List.of(node.protocol.state(), node.held(), node.num, node.ts, node.want)
          + node.consentedTo
          + proposed
          + learned;
    }

    Reached after(Step step) {
      return after.computeIfAbsent(
          step.line(),
          line -> {
            List<Step> longer = new ArrayList<>(steps);
            longer.add(step);
            List<MutexMessage> sent = new ArrayList<>();
            View newest = step.learned() == View.NONE ? learned : step.learned();
            Local local = local(node.id, longer, newest, sent);
            BitSet numbers = new BitSet();
            sent.forEach(message -> numbers.set(number(message)));
            return new Reached(local, numbers);
          });
    }
  }

  private final class State {
    final List<Local> locals;
    private final BitSet sent;
    private final List<View> views;
    private final int suspicions;
    private final int crashes;
    private final @Nullable State before;
    private final String line;

    State(
        List<Local> locals,
        BitSet sent,
        List<View> views,
        int suspicions,
        int crashes,
        @Nullable State before,
        String line) {
      this.locals = locals;
      this.sent = sent;
      this.views = views;
      this.suspicions = suspicions;
      this.crashes = crashes;
      this.before = before;
      this.line = line;
    }

    View lastView() {
      return views.get(views.size() - 1);
    }

    /** Crashes are in the participants' states. */
    String key() {
      StringBuilder key = new StringBuilder();
      locals.forEach(local -> key.append((char) (local.number >> 8)).append((char) (local.number & 0xFF)));
      key.append((char) suspicions).append((char) views.size());
      for (long bits : sent.toLongArray()) {
        for (int at = 0; at < Long.SIZE; at += Byte.SIZE) {
          key.append((char) (bits >>> at & 0xFF));
        }
      }
      views.subList(shape.views().size(), views.size()).forEach(key::append);
      return key.toString();
    }

    List<String> story(String last) {
      ArrayDeque<String> story = new ArrayDeque<>(List.of(last));
      for (State state = this; state.before != null; state = state.before) {
        story.addFirst(state.line);
      }
      return List.copyOf(story);
    }

    /** The states after one step. */
    List<State> next() {
      List<State> all = new ArrayList<>();
      for (int i = 0; i < locals.size(); i++) {
        if (!locals.get(i).node.dead) {
          addSteps(i, all);
        }
      }
      return all;
    }

    private void addSteps(int i, List<State> all) {
      Local local = locals.get(i);
      MutexNode node = local.node;
      boolean mayRequest = i < shape.requesters() && node.num < shape.requests();
      if (mayRequest && node.isIn(Phase.IDLE) && node.protocol.mayRequest()) {
        for (List<String> want : shape.wants()) {
          all.add(
              after(i, "requests " + want, n -> n.protocol.request(Sections.copyOf(want), 0)));
        }
      }
      if (node.isIn(Phase.TRYING) && shape.withdrawals()) {
        all.add(after(i, "withdraws", n -> n.protocol.withdraw(MutexFailure.WITHDRAWN)));
      }
      if (node.isIn(Phase.CRITICAL)) {
        for (String section : node.protocol.held()) {
          all.add(
              after(
                  i,
                  "releases " + section,
                  n -> n.protocol.release(new TreeSet<>(List.of(section)))));
        }
      }
      if (node.isIn(Phase.TRYING) && suspicions < shape.suspicions()) {
        for (ProcessId other : node.protocol.missing()) {
          State next = after(i, "suspects " + other, n -> n.protocol.suspect(other, 0));
          all.add(next.with(views, suspicions + 1, crashes));
        }
      }
      if (crashes < shape.crashes()) {
        all.add(after(i, "crashes", MutexNode::diesHolding).with(views, suspicions, crashes + 1));
      }
      for (Confinement each : node.proposed) {
        if (each.changes(lastView()) && each.hasFencersIn(lastView())) {
          List<View> longer = new ArrayList<>(views);
          longer.add(each.applyTo(lastView().next()));
          State next = new State(locals, sent, longer, suspicions, crashes, this, each.toString());
          all.add(next);
        }
      }
      for (View view : views) {
        boolean isOut = local.learned.equals(View.NONE) && !view.contains(node.id);
        if (view.number() > local.learned.number() && !isOut) {
          all.add(after(i, learns(local, view)));
        }
      }
      for (int m = sent.nextSetBit(0); m >= 0; m = sent.nextSetBit(m + 1)) {
        MutexMessage message = messages.get(m);
        if (node.id.equals(message.to())) {
          all.add(
              after(i, new Step(message.toString(), View.NONE, n -> n.protocol.receive(message, 0))));
        }
      }
    }

    private State after(int i, String what, Consumer<MutexNode> action) {
      return after(i, new Step(locals.get(i).node.id + " " + what, View.NONE, action));
    }

    private State after(int i, Step step) {
      Reached reached = locals.get(i).after(step);
      List<Local> now = new ArrayList<>(locals);
      now.set(i, reached.local());
      BitSet more = (BitSet) sent.clone();
      more.or(reached.sent());
      // What nobody will receive makes no state another one.
      more.andNot(toDead(now));
      return new State(now, more, views, suspicions, crashes, this, step.line());
    }

    private BitSet toDead(List<Local> now) {
      BitSet dropped = new BitSet();
      for (Local local : now) {
        for (int m = 0; local.node.dead && m < messages.size(); m++) {
          dropped.set(m, messages.get(m).to().equals(local.node.id) || dropped.get(m));
        }
      }
      return dropped;
    }

    private State with(List<View> newViews, int newSuspicions, int newCrashes) {
      return new State(locals, sent, newViews, newSuspicions, newCrashes, before, line);
    }
  }
}
