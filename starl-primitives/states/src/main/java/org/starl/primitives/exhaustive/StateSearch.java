package org.starl.primitives.exhaustive;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;

/**
 * Visits every state of a few participants that run a protocol's code, breadth first, as a model
 * checker visits those of a model. Messages stay in a set for ever, which covers loss, delay,
 * duplication and reordering. There is no clock: what a timer may do is a step that is always
 * possible.
 *
 * <p>A message that its recipient answers without a change of its own state is answered at once: this
 * leaves out no state of participants, since they can do more, the more is sent.
 *
 * <p>Participants depend on each other only through messages and the shared state. So the protocol
 * runs once for each state of one participant and each step of it ({@link Local}); states of all
 * participants are tuples of these. A protocol cannot be copied: its state is reached again by
 * repeating the participant's own steps.
 *
 * @param <N> a participant
 * @param <M> a message; equal texts are equal messages
 * @param <S> state outside the participants; immutable, equal texts are equal states
 */
public final class StateSearch<N, M, S> {

  /** The participants and what they may do. */
  public interface Model<N, M, S> {

    /** The number of participants. */
    int size();

    /** Participant {@code i} at its start, which sends to {@code net}. */
    N make(int i, Consumer<M> net);

    /** The state of a participant: with equal texts it behaves alike. */
    String text(N node);

    /** The participant that receives {@code message}. */
    int to(M message);

    void receive(N node, M message);

    /**
     * Whether {@code message} has no effect on its recipient, now and in every later state: states
     * that differ in such messages count once.
     */
    boolean isSpent(N recipient, M message);

    S begin();

    /** Adds the steps of participant {@code i} other than to receive a message. */
    void addSteps(int i, List<N> nodes, S shared, Steps<N, S> steps);

    /** The first violated invariant, if one is violated. */
    Optional<String> violation(List<N> nodes, S shared);

    /** Whether the protocol has reached in this state what it is for. */
    boolean isReached(List<N> nodes);
  }

  /** Receives the steps of a participant. */
  @FunctionalInterface
  public interface Steps<N, S> {

    /**
     * @param line identifies the step
     * @param after the shared state after it
     */
    void add(String line, Consumer<N> action, S after);
  }

  /**
   * The result.
   *
   * @param states the visited ones
   * @param reached those in which the protocol has reached what it is for
   * @param steps the steps between them
   * @param isComplete whether there are no others
   * @param violation the fewest steps that change a participant to a violation, with the answers between,
   *     and what is violated; empty if nothing is
   */
  public record Outcome(
      int states, int reached, long steps, boolean isComplete, List<String> violation) {}

  private static final int PROGRESS_EVERY = 1000;

  private final Model<N, M, S> model;
  private final Map<String, Local> locals = new LinkedHashMap<>();
  private final List<M> messages = new ArrayList<>();
  private final Map<String, Integer> messageNumbers = new LinkedHashMap<>();

  public StateSearch(Model<N, M, S> model) {
    this.model = model;
  }

  /**
   * Visits at most {@code mostStates}.
   *
   * @param progress gets the number of visited states, each thousand
   */
  public Outcome run(int mostStates, IntConsumer progress) {
    Set<String> seen = new LinkedHashSet<>();
    ArrayDeque<State> frontier = new ArrayDeque<>();
    State first = first();
    seen.add(first.key());
    frontier.add(first);
    int reached = 0;
    long steps = 0;
    while (!frontier.isEmpty()) {
      for (State next : frontier.remove().next()) {
        steps++;
        if (!seen.add(next.key())) {
          continue;
        }
        if (seen.size() > mostStates) {
          return new Outcome(mostStates, reached, steps, false, List.of());
        }
        if (seen.size() % PROGRESS_EVERY == 0) {
          progress.accept(seen.size());
        }
        List<N> nodes = next.nodes();
        reached += model.isReached(nodes) ? 1 : 0;
        Optional<String> violation = model.violation(nodes, next.shared);
        if (violation.isPresent()) {
          return new Outcome(seen.size(), reached, steps, false, next.story(violation.get()));
        }
        frontier.add(next);
      }
    }
    return new Outcome(seen.size(), reached, steps, true, List.of());
  }

  private State first() {
    List<Local> begun = new ArrayList<>();
    BitSet sent = new BitSet();
    for (int i = 0; i < model.size(); i++) {
      Reached<Local> reached = reached(i, List.of());
      begun.add(reached.local());
      sent.or(reached.sent());
    }
    answer(begun, sent);
    return new State(begun, sent, model.begin(), null, 0, "");
  }

  /** Messages that {@code message} brings its recipient to send, which stays as it is. */
  private record Answers(int message, BitSet sent) {}

  /**
   * Adds to {@code sent} all answers of recipients that stay as they are, and drops what is spent. The
   * more is sent, the more can happen: so no state of participants is left out.
   */
  private Deque<Answers> answer(List<Local> locals, BitSet sent) {
    Deque<Answers> all = new ArrayDeque<>();
    removeSpent(locals, sent);
    BitSet open = (BitSet) sent.clone();
    for (int m = open.nextSetBit(0); m >= 0; m = open.nextSetBit(0)) {
      open.clear(m);
      Local local = locals.get(model.to(messages.get(m)));
      Reached<Local> reached = local.after(m);
      if (reached.local() == local) {
        BitSet answers = (BitSet) reached.sent().clone();
        answers.andNot(sent);
        removeSpent(locals, answers);
        sent.or(answers);
        open.or(answers);
        if (!answers.isEmpty()) {
          all.addFirst(new Answers(m, answers));
        }
      }
    }
    return all;
  }

  private void removeSpent(List<Local> locals, BitSet sent) {
    for (int m = sent.nextSetBit(0); m >= 0; m = sent.nextSetBit(m + 1)) {
      M message = messages.get(m);
      if (model.isSpent(locals.get(model.to(message)).node, message)) {
        sent.clear(m);
      }
    }
  }

  /** The state of a participant after a step, and the messages that the step sent. */
  private record Reached<L>(L local, BitSet sent) {}

  private Reached<Local> reached(int i, List<Consumer<N>> steps) {
    List<M> sent = new ArrayList<>();
    N node = model.make(i, sent::add);
    for (Consumer<N> step : steps) {
      sent.clear();
      step.accept(node);
    }
    BitSet numbers = new BitSet();
    sent.forEach(message -> numbers.set(number(message)));
    Local local = new Local(i, node, steps, locals.size());
    return new Reached<>(locals.computeIfAbsent(i + model.text(node), any -> local), numbers);
  }

  private int number(M message) {
    return messageNumbers.computeIfAbsent(
        message.toString(),
        text -> {
          messages.add(message);
          return messages.size() - 1;
        });
  }

  /** A state of one participant, reached by steps of its own. */
  private final class Local {
    final N node;
    final int number;
    private final int i;
    private final List<Consumer<N>> steps;
    private final Map<String, Reached<Local>> after = new LinkedHashMap<>();
    private final Map<Integer, Reached<Local>> afterMessage = new LinkedHashMap<>();

    Local(int i, N node, List<Consumer<N>> steps, int number) {
      this.i = i;
      this.node = node;
      this.steps = steps;
      this.number = number;
    }

    Reached<Local> after(int m) {
      M message = messages.get(m);
      return afterMessage.computeIfAbsent(
          m, any -> after(message.toString(), participant -> model.receive(participant, message)));
    }

    Reached<Local> after(String line, Consumer<N> action) {
      return after.computeIfAbsent(
          line,
          any -> {
            List<Consumer<N>> longer = new ArrayList<>(steps);
            longer.add(action);
            return reached(i, longer);
          });
    }
  }

  private final class State {
    private final List<Local> locals;
    private final BitSet sent;
    private final S shared;
    private final @Nullable State before;
    private final int who;
    private final String line;

    /**
     * @param before the state before, after which participant {@code who} took the step {@code line}
     */
    State(List<Local> locals, BitSet sent, S shared, @Nullable State before, int who, String line) {
      this.locals = locals;
      this.sent = sent;
      this.shared = shared;
      this.before = before;
      this.who = who;
      this.line = line;
    }

    List<N> nodes() {
      List<N> nodes = new ArrayList<>();
      locals.forEach(local -> nodes.add(local.node));
      return nodes;
    }

    String key() {
      StringBuilder key = new StringBuilder();
      for (Local local : locals) {
        key.append((char) (local.number >>> Byte.SIZE)).append((char) (local.number & 0xFF));
      }
      for (byte bits : sent.toByteArray()) {
        key.append((char) (bits & 0xFF));
      }
      return key.append(shared).toString();
    }

    /** The steps to this state, with the answers that they need. */
    List<String> story(String last) {
      ArrayDeque<String> story = new ArrayDeque<>(List.of(last));
      BitSet needed = new BitSet();
      State state = this;
      for (State start = before; start != null; start = start.before) {
        Reached<Local> step = start.locals.get(state.who).after(state.line, participant -> {});
        BitSet all = (BitSet) start.sent.clone();
        all.or(step.sent());
        for (Answers each : answer(state.locals, all)) {
          if (each.sent().intersects(needed)) {
            needed.set(each.message());
            story.addFirst(messages.get(each.message()).toString());
          }
        }
        Integer message = messageNumbers.get(state.line);
        if (message != null) {
          needed.set(message);
        }
        story.addFirst(state.line);
        state = start;
      }
      return List.copyOf(story);
    }

    /** The states after one step. */
    List<State> next() {
      List<State> all = new ArrayList<>();
      List<N> nodes = nodes();
      for (int i = 0; i < locals.size(); i++) {
        int me = i;
        model.addSteps(
            i,
            nodes,
            shared,
            (text, action, after) ->
                all.add(after(me, text, locals.get(me).after(text, action), after)));
      }
      for (int m = sent.nextSetBit(0); m >= 0; m = sent.nextSetBit(m + 1)) {
        int to = model.to(messages.get(m));
        Reached<Local> reached = locals.get(to).after(m);
        if (reached.local() != locals.get(to)) {
          all.add(after(to, messages.get(m).toString(), reached, shared));
        }
      }
      return all;
    }

    private State after(int i, String text, Reached<Local> reached, S newShared) {
      List<Local> now = new ArrayList<>(locals);
      now.set(i, reached.local());
      BitSet more = (BitSet) sent.clone();
      more.or(reached.sent());
      answer(now, more);
      return new State(now, more, newShared, this, i, text);
    }
  }
}
