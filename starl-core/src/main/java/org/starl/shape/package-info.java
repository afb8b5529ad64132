/**
 * Shapes: one declaration of a type of values gives its bytes on the wire, its JSON text in traces,
 * and its row in the documentation. A {@link org.starl.shape.Shape} of a record lists its parts, that
 * of a sealed interface its records:
 *
 * <pre>{@code
 * record Crate(int number, double kg) {
 *   static final Shape<Crate> SHAPE =
 *       Shapes.of(
 *           Crate.class, part("number", INT, Crate::number), part("kg", REAL, Crate::kg), Crate::new);
 * }
 * }</pre>
 *
 * <p>Writing a value and reading it back gives an equal value, by bytes and by JSON. Bytes that no
 * value has are a {@link org.starl.shape.WireFormatException}; such a line of JSON is a {@link
 * org.starl.shape.JsonFormatException} with file, line and column. Shapes are immutable and need no
 * reflection.
 *
 * <p>May import: {@code org.starl} ids, {@code org.starl.geometry}.
 */
@NullMarked
package org.starl.shape;

import org.jspecify.annotations.NullMarked;
