package org.starl.shape;

/**
 * A JSON value of which no shape is known: it is kept as it was read.
 *
 * @param text the value without white space
 */
public record Json(String text) {

  /** The JSON string of {@code text}. */
  public static Json string(String text) {
    JsonWriter out = new JsonWriter();
    out.string(text);
    return new Json(out.textFrom(0));
  }

  @Override
  public String toString() {
    return text;
  }
}
