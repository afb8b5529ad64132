package org.starl.apps.lightpaint.logic;

import static org.starl.shape.Shapes.BOOL;
import static org.starl.shape.Shapes.INT;
import static org.starl.shape.Shapes.REAL;
import static org.starl.shape.Shapes.part;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.Persistent;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * The stroke that a painter works on, if any, its progress, and the note of both on stable storage:
 * after a restart the painter continues from the note. Strand only.
 */
final class CurrentWork {

  /** {@link #number} while there is no work. */
  static final int NONE = -1;

  private static final String KEY = "lightpaint/work";
  private static final double NOTE_EVERY_MM = 10;

  /** A shorter remainder counts as done: the painter stands at its end already. */
  private static final double MIN_REST_MM = 8;

  /** Upper bound of what a painter paints between two calls of {@link #paintedTo}. */
  private static final double MAX_STEP_MM = 50;

  /** Upper bound of what a painter paints between two notes. */
  private static final double MAX_UNNOTED_MM = 150;

  /** What is on stable storage. */
  private record Note(int stroke, boolean isReversed, double doneMm, boolean isAtWork) {
    private static final Shape<Note> SHAPE =
        Shapes.of(
            Note.class,
            part("stroke", INT, Note::stroke),
            part("isReversed", BOOL, Note::isReversed),
            part("doneMm", REAL, Note::doneMm),
            part("isAtWork", BOOL, Note::isAtWork),
            Note::new);
    private static final Note NONE = new Note(CurrentWork.NONE, false, 0, false);
  }

  private final List<Stroke> strokes;
  private final Persistent<Note> noted;
  private final GvhCell<Integer> number;
  private boolean isReversed;

  /** Painted so far, from the start of {@link #path}. */
  private double doneMm;

  private double notedMm;

  CurrentWork(GlobalVarHolder gvh, List<Stroke> strokes) {
    this.strokes = strokes;
    noted = gvh.plat.persistent(KEY, Note.SHAPE, Note.NONE);
    number = gvh.variable(PaintFact.STROKE, NONE);
  }

  boolean isNone() {
    return number() == NONE;
  }

  /** The stroke's number, or {@link #NONE}. */
  int number() {
    return number.get();
  }

  Stroke stroke() {
    return strokes.get(number());
  }

  /** The stroke in the painter's direction. */
  private Polyline path() {
    return isReversed ? stroke().path().reversed() : stroke().path();
  }

  /** Where painting continues. */
  Point next() {
    return path().at(doneMm);
  }

  Polyline rest() {
    Polyline path = path();
    return path.between(doneMm, path.lengthMm());
  }

  /** Whether the stroke is painted; one that is shorter than the remainder is painted as well. */
  boolean isDone() {
    return doneMm > 0 && path().lengthMm() - doneMm < MIN_REST_MM;
  }

  /** Begins with {@code stroke}, at the end that is nearer to {@code here}. */
  void begin(Stroke stroke, Point here) {
    number.set(stroke.number());
    isReversed = stroke.path().end().distanceMm(here) < stroke.path().start().distanceMm(here);
    doneMm = 0;
  }

  /** Records that the painter, with its light on, has come to {@code here}. */
  void paintedTo(Point here) {
    doneMm = path().nearestMm(here, doneMm, doneMm + MAX_STEP_MM);
  }

  void finish() {
    doneMm = path().lengthMm();
  }

  /** Ends the work and erases the note. */
  void drop() {
    number.set(NONE);
    noted.set(Note.NONE);
  }

  /**
   * Writes the note if the painter, which is painting, has come 10 mm farther than the note says.
   */
  void noteProgress() {
    if (doneMm >= notedMm + NOTE_EVERY_MM) {
      note(true);
    }
  }

  /**
   * Writes the note.
   *
   * @param isAtWork whether the painter stays on the stroke, where the work continues
   */
  void note(boolean isAtWork) {
    noted.set(new Note(number(), isReversed, doneMm, isAtWork));
    notedMm = doneMm;
  }

  /** Whether the latest note would survive a crash. */
  boolean isNoted() {
    return noted.isFlushed();
  }

  /**
   * Reads the note at the start of the program.
   *
   * @param here where the painter stands: if it was painting, this tells its progress more exactly
   *     than the note
   * @param errorMm the error of {@code here}
   */
  void resume(Point here, double errorMm) {
    Note note = noted.get();
    if (note.stroke() != NONE) {
      number.set(note.stroke());
      isReversed = note.isReversed();
      doneMm = note.doneMm();
      if (note.isAtWork()) {
        doneMm = resumed(here, errorMm);
      }
      // Perhaps its light was never on.
      if (note.doneMm() == 0 && isDone()) {
        doneMm = 0;
      }
    }
  }

  /** The place of {@code here}; of several, where the stroke is near to itself, the first. */
  private double resumed(Point here, double errorMm) {
    double nearestMm = path().nearestMm(here, doneMm, doneMm + MAX_UNNOTED_MM);
    double withinMm = path().at(nearestMm).distanceMm(here) + errorMm;
    return path().feetMm(here, withinMm).stream()
        .filter(footMm -> footMm >= doneMm && footMm <= nearestMm)
        .findFirst()
        .orElse(nearestMm);
  }
}
