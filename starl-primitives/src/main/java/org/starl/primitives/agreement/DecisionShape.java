package org.starl.primitives.agreement;

import java.util.Optional;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.JsonWriter;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/**
 * The shape of decisions: their bytes, or none. A reader need not know the shape of the values: it
 * reads a decision on a text, the bytes in hexadecimal digits.
 */
final class DecisionShape implements Shape<Decision<?>> {

  private static final Shape<Optional<Value>> BYTES = Shapes.optional(Value.SHAPE);

  @Override
  public void write(Decision<?> decision, WireWriter out) {
    BYTES.write(bytes(decision), out);
  }

  @Override
  public Decision<?> read(WireReader in) {
    return decision(BYTES.read(in));
  }

  @Override
  public void writeJson(Decision<?> decision, JsonWriter out) {
    BYTES.writeJson(bytes(decision), out);
  }

  @Override
  public Decision<?> readJson(JsonReader in) throws JsonFormatException {
    return decision(BYTES.readJson(in));
  }

  @Override
  public String describe() {
    return BYTES.describe();
  }

  private static Optional<Value> bytes(Decision<?> decision) {
    return decision instanceof Decision.Decided<?> decided
        ? Optional.of(decided.bytes())
        : Optional.empty();
  }

  private static Decision<?> decision(Optional<Value> bytes) {
    if (!bytes.isPresent()) {
      return new Decision.NoneYet<String>();
    }
    return new Decision.Decided<>(bytes.get().toString(), bytes.get());
  }
}
