package org.starl.sim.view.page;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.sim.record.BoundingBox;
import org.starl.sim.record.Viewport;
import org.starl.sim.replay.Cursor;
import org.starl.sim.replay.Mark;
import org.starl.sim.replay.Recording;
import org.starl.sim.view.Traffic;
import org.starl.time.Time;

/**
 * The page of a recording that may still grow. A browser loads {@link #html} and then takes the
 * parts, one after another: the first has what a page in a file has, each later one adds pictures.
 * Parts are made when a browser asks, once for all browsers, so a page without a browser costs
 * nothing, and a slow browser delays neither the run nor another browser. Thread-safe.
 */
public final class LivePage {

  /** Simulated time between two pictures, in ns; the browser interpolates. */
  public static final long EVERY_NS = RunPage.EVERY_NS;

  /** After so many pictures a page begins again with the latest one. */
  private static final int MOST_PICTURES = 20_000;

  /** Or when its parts have more characters than this: a picture of many robots has many. */
  private static final long MOST_CHARACTERS = 32 << 20;

  /** Limits the time for which one browser keeps others waiting. */
  private static final int MOST_AT_ONCE = 40;

  private static final long MOST_CHARACTERS_AT_ONCE = 4 << 20;

  /**
   * One part of a page.
   *
   * @param number of this part; the next one has the next number
   * @param isFirst whether it replaces all parts before
   * @param json one line
   */
  public record Part(int number, boolean isFirst, String json) {}

  private final Recording recording;
  private final double speed;
  private final int mostPictures;
  private final long mostCharacters;
  private final ObjectMapper mapper = new ObjectMapper();
  private final Cursor cursor;
  private final Traffic traffic;
  private final List<Part> parts = new ArrayList<>();

  // Of the pictures since the first part that is kept.
  private @Nullable PageFrames frames;
  private @Nullable Viewport viewport;
  private int nextNumber;
  private int pictures;
  private long characters;
  private long charactersPerPicture = MOST_CHARACTERS_AT_ONCE;
  private int texts;
  private int styles;
  private int marks;
  private long fromNs;
  private long nextNs;
  private boolean isWhole;

  /**
   * @param speed simulated seconds per real second, at which a browser follows the run; 0 if the run
   *     has no such speed: a browser then plays from the start
   */
  public LivePage(Recording recording, double speed) {
    this(recording, speed, MOST_PICTURES, MOST_CHARACTERS);
  }

  LivePage(Recording recording, double speed, int mostPictures, long mostCharacters) {
    this.mostCharacters = mostCharacters;
    this.recording = recording;
    this.speed = speed;
    this.mostPictures = mostPictures;
    cursor = new Cursor(recording);
    traffic = new Traffic(recording);
  }

  /**
   * The page without pictures.
   *
   * @param source the address of the parts: server-sent events {@code begin}, for a first part, and
   *     {@code more}, and {@code end} after the last one
   */
  public static String html(String title, String source) {
    return RunPage.live(title, source);
  }

  /**
   * The part with this number; if it is gone, the first one that is kept.
   *
   * @return null if it is not there yet; {@link #isWhole} tells whether it ever will be
   */
  public synchronized @Nullable Part part(int number) {
    if (number >= nextNumber) {
      advance();
    }
    if (number >= nextNumber || parts.isEmpty()) {
      return null;
    }
    return parts.get(Math.max(0, number - parts.get(0).number()));
  }

  /** Whether no part follows those so far: the run is over. */
  public synchronized boolean isWhole() {
    return isWhole;
  }

  /** Makes the next part, if there is anything new. */
  private void advance() {
    // In this order: what is over grows no more, what is checked gets no more marks.
    boolean isOver = recording.isOver();
    boolean isChecked = recording.isChecked();
    long endNs = recording.endNs();
    if (isWhole || !recording.hasBegun()) {
      isWhole |= isOver;
      return;
    }
    List<Long> due = due(endNs, isOver);
    List<Mark> allMarks = recording.marks();
    List<Mark> newMarks = allMarks.subList(marks, allMarks.size());
    boolean isLast = isOver && isChecked && nextNs == Long.MAX_VALUE;
    if (due.isEmpty() && newMarks.isEmpty() && !isLast) {
      return;
    }
    boolean isFull = pictures > mostPictures || characters > mostCharacters;
    boolean isFirst = frames == null || (isFull && !due.isEmpty());
    if (isFirst && due.isEmpty()) {
      return;
    }
    if (isFirst) {
      begin(due.get(0));
      newMarks = allMarks;
    }
    isWhole = isLast;
    add(isFirst, due, newMarks);
  }

  /**
   * The times of the next pictures. The events of a moment are all known when the run is later; the
   * last picture is the end's.
   */
  private List<Long> due(long endNs, boolean isOver) {
    List<Long> due = new ArrayList<>();
    long most =
        Math.clamp(MOST_CHARACTERS_AT_ONCE / Math.max(1, charactersPerPicture), 1, MOST_AT_ONCE);
    while (due.size() < most && nextNs < endNs) {
      due.add(nextNs);
      nextNs += EVERY_NS;
    }
    if (isOver && due.size() < most && nextNs < Long.MAX_VALUE) {
      due.add(endNs);
      nextNs = Long.MAX_VALUE;
    }
    return due;
  }

  private void begin(long beginNs) {
    fromNs = beginNs;
    cursor.seek(beginNs);
    viewport = RunPage.viewport(BoundingBox.of(cursor.scene(), cursor.layer()));
    frames = new PageFrames(viewport, RunPage.look(recording));
    parts.clear();
    pictures = 0;
    characters = 0;
    texts = 0;
    styles = 0;
    marks = 0;
  }

  private void add(boolean isFirst, List<Long> due, List<Mark> newMarks) {
    PageFrames shown = frames;
    Viewport seen = viewport;
    if (shown == null || seen == null) {
      throw new IllegalStateException("a picture before the first part");
    }
    for (long timeNs : due) {
      cursor.seek(timeNs);
      shown.add(cursor.scene(), cursor.layer(), traffic.at(timeNs, cursor.index(), EVERY_NS, null));
    }
    Map<String, Object> part =
        isFirst
            ? RunPage.head(RunPage.title(recording), seen, EVERY_NS, due.get(0))
            : new LinkedHashMap<>();
    if (isFirst) {
      part.put("speed", speed);
      part.put("leftOut", leftOut());
    }
    part.put("toMs", RunPage.millis(cursor.nowNs()));
    part.put("isOver", isWhole);
    if (isWhole) {
      RunPage.putFailure(part, recording);
      part.put("sequence", RunPage.sequence(recording, fromNs, recording.endNs()));
      part.put("lanes", RunPage.lanes(recording, shown, fromNs, recording.endNs()));
    }
    part.put("box", seen.box(BoundingBox.of(cursor.scene(), cursor.layer())));
    part.put("marks", RunPage.marks(newMarks, 0, Long.MAX_VALUE));
    part.put("texts", shown.texts().subList(texts, shown.texts().size()));
    part.put("styles", shown.styles().subList(styles, shown.styles().size()));
    part.put("frames", shown.takeFrames());
    pictures += due.size();
    marks += newMarks.size();
    texts = shown.texts().size();
    styles = shown.styles().size();
    try {
      String json = mapper.writeValueAsString(part);
      parts.add(new Part(nextNumber++, isFirst, json));
      characters += json.length();
      charactersPerPicture = due.isEmpty() ? charactersPerPicture : json.length() / due.size();
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("a picture that is not JSON", e);
    }
  }

  /** What a page that has begun again lacks, in one line; empty if it lacks nothing. */
  private String leftOut() {
    return fromNs == 0
        ? ""
        : "Pictures before %s are left out: a page that grows keeps only the latest"
            .formatted(Time.text(fromNs, 1));
  }

  /** The simulated time that the recording has reached, in s, and what ended it. */
  public String state() {
    if (!recording.hasBegun()) {
      return "starts";
    }
    String time = Time.text(recording.endNs(), 1);
    boolean isBad = recording.marks().stream().anyMatch(mark -> mark.kind() == Mark.Kind.VIOLATION);
    String how =
        !recording.failure().isEmpty()
            ? "failed at "
            : !recording.isOver() ? "at " : isBad ? "violated, ended at " : "ended at ";
    return how + time;
  }
}
