package org.starl.trace;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.starl.shape.Json;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.RecordShape;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;

/**
 * The shapes of the messages, facts and variables of an app and its primitives: what a reader of a
 * trace needs to read typed values. What it does not know, or what its shape cannot read (that of a
 * {@code Codec}), is read as {@link Json}, or as a String if it is one.
 * Immutable.
 */
public final class Vocabulary {

  /** Knows nothing but notes. */
  public static final Vocabulary NONE = new Vocabulary(Map.of(), Map.of(), Map.of());

  /** For people: a JSON string is its text, as the value's own text was. */
  private static final Shape<Object> UNREAD =
      Shapes.JSON.as(
          "json",
          value -> value instanceof Json json ? json : Json.string(value.toString()),
          Vocabulary::unread);

  // By the kind of a channel, or by its whole name, which goes before.
  private final Map<String, Shape<?>> messages;

  // By primitive and name.
  private final Map<String, RecordShape<?>> facts;
  private final Map<String, Var<?>> variables;

  private Vocabulary(
      Map<String, Shape<?>> messages,
      Map<String, RecordShape<?>> facts,
      Map<String, Var<?>> variables) {
    this.messages = Collections.unmodifiableMap(messages);
    this.facts = Collections.unmodifiableMap(facts);
    this.variables = Collections.unmodifiableMap(variables);
  }

  /** With messages of all channels of this kind: {@code mutex}, {@code election.synod}. */
  public Vocabulary messages(String kind, Shape<?> shape) {
    Map<String, Shape<?>> all = new LinkedHashMap<>(messages);
    all.put(kind, shape);
    return new Vocabulary(all, facts, variables);
  }

  /** With messages of one channel, such as a broadcast of an app's own type. */
  public Vocabulary messages(Instance channel, Shape<?> shape) {
    return messages(channel.name(), shape);
  }

  /** With facts of a primitive, or of an app: the records of a sum. */
  public Vocabulary facts(String primitive, SumShape<?> shape) {
    return facts(primitive, shape.records().toArray(new RecordShape<?>[0]));
  }

  /** With facts of a primitive, or of an app. */
  public Vocabulary facts(String primitive, RecordShape<?>... shapes) {
    Map<String, RecordShape<?>> all = new LinkedHashMap<>(facts);
    for (RecordShape<?> shape : shapes) {
      all.put(key(primitive, shape.name()), shape);
    }
    return new Vocabulary(messages, all, variables);
  }

  /** With variables of a primitive, or of an app. */
  public Vocabulary variables(String primitive, Var<?>... added) {
    Map<String, Var<?>> all = new LinkedHashMap<>(variables);
    for (Var<?> variable : added) {
      all.put(key(primitive, variable.name()), variable);
    }
    return new Vocabulary(messages, facts, all);
  }

  /** With all that {@code other} knows. */
  public Vocabulary and(Vocabulary other) {
    return new Vocabulary(
        both(messages, other.messages), both(facts, other.facts), both(variables, other.variables));
  }

  private static <V> Map<String, V> both(Map<String, V> these, Map<String, V> others) {
    Map<String, V> all = new LinkedHashMap<>(these);
    all.putAll(others);
    return all;
  }

  /** All that {@code several} know. */
  public static Vocabulary of(List<Vocabulary> several) {
    return several.stream().reduce(NONE, Vocabulary::and);
  }

  /**
   * With the shapes of this event, so that a reader makes an equal one of its line. If two events of
   * different types have one name, readers get both as {@link Json}.
   */
  public Vocabulary with(TraceEvent event) {
    return switch (event) {
      case TraceEvent.Action e -> withFact(e.source().primitive(), e.shape());
      case TraceEvent.Variable e -> withVariable(e.source().primitive(), e.variable());
      case TraceEvent.Sent e -> withMessages(e.channel(), e.shape());
      case TraceEvent.Delivered e -> withMessages(e.channel(), e.shape());
      default -> this;
    };
  }

  private Vocabulary withFact(String primitive, RecordShape<?> shape) {
    RecordShape<?> known = facts.get(key(primitive, shape.name()));
    if (known == null) {
      return facts(primitive, shape);
    }
    boolean isRead = known.type() == shape.type() || known.type() == Json.class;
    return isRead ? this : facts(primitive, RecordShape.unknown(shape.name()));
  }

  private Vocabulary withVariable(String primitive, Var<?> variable) {
    Var<?> known = variables.get(key(primitive, variable.name()));
    if (known == null) {
      return variables(primitive, variable);
    }
    boolean isRead = known.shape() == variable.shape() || known.shape() == UNREAD;
    return isRead ? this : variables(primitive, Var.of(variable.name(), UNREAD));
  }

  // All robots of a channel have messages of one type.
  private Vocabulary withMessages(Instance channel, Shape<?> shape) {
    return messages.containsKey(channel.name()) ? this : messages(channel, shape);
  }

  /** The shape of the messages of a channel. */
  public Shape<?> message(Instance channel) {
    Shape<?> shape = messages.get(channel.name());
    shape = shape == null ? messages.get(channel.kind()) : shape;
    return shape == null || !shape.isReadable() ? UNREAD : shape;
  }

  private static Object unread(Json json) {
    try {
      return json.text().startsWith("\"") ? new JsonReader("", 0, json.text()).text("") : json;
    } catch (JsonFormatException e) {
      throw new IllegalArgumentException(e);
    }
  }

  /** The shape of an instance's fact of this name; null if it is unknown, or cannot be read. */
  public @Nullable RecordShape<?> fact(Instance source, String name) {
    RecordShape<?> known =
        name.equals(Note.SHAPE.name()) ? Note.SHAPE : facts.get(key(source.primitive(), name));
    return known == null || !known.isReadable() ? null : known;
  }

  /** An instance's variable of this name. */
  public Var<?> variable(Instance source, String name) {
    Var<?> known = variables.get(key(source.primitive(), name));
    return known == null || !known.shape().isReadable() ? Var.of(name, UNREAD) : known;
  }

  /** The shapes of all messages, by kind or name of the channel. */
  public Map<String, Shape<?>> messages() {
    return messages;
  }

  /** The shapes of all facts, by primitive and name. */
  public Map<String, RecordShape<?>> facts() {
    return facts;
  }

  /** All variables, by primitive and name. */
  public Map<String, Var<?>> variables() {
    return variables;
  }

  private static String key(String primitive, String name) {
    return Objects.requireNonNull(primitive) + " " + name;
  }
}
