package org.starl.trace;

import java.util.List;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;

/**
 * A fact without a declaration of its own: a name and texts, for people who read the trace.
 *
 * @param name of the action
 */
public record Note(String name, List<String> texts) {

  private static final int MOST_TEXTS = 255;

  /** The shape of notes. */
  public static final RecordShape<Note> SHAPE =
      Shapes.of(
              Note.class,
              Shapes.part("name", Shapes.TEXT, Note::name),
              Shapes.part("texts", Shapes.list(Shapes.TEXT, MOST_TEXTS), Note::texts),
              Note::new)
          .named("note");

  public Note {
    texts = List.copyOf(texts);
  }
}
