package org.starl.spec;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A monitor with a table of its lemmas and their descriptions. */
public abstract class LemmaMonitor implements Monitor {

  private final Map<String, String> sentences = new LinkedHashMap<>();
  private final List<String> progress = new ArrayList<>();
  private final Map<String, String> inapplicable = new LinkedHashMap<>();
  private final Map<String, String> inPart = new LinkedHashMap<>();

  /** Adds a lemma, and the sentence that explains it to a user. For constructors. */
  protected final void lemma(String name, String sentence) {
    sentences.put(name, sentence);
  }

  /** Adds a lemma of progress: as {@link #lemma}. */
  protected final void progress(String name, String sentence) {
    lemma(name, sentence);
    progress.add(name);
  }

  /** Declares that runs like this one never check a lemma, with the reason. Before {@link #finish} ends. */
  protected final void never(String name, String reason) {
    inapplicable.put(name, reason);
  }

  @Override
  public final Map<String, String> inapplicable() {
    return Collections.unmodifiableMap(inapplicable);
  }

  /** Declares that a lemma is not checked from now on. The first reason stays. */
  protected final void ends(String name, String reason) {
    inPart.putIfAbsent(name, reason);
  }

  @Override
  public final Map<String, String> inPart() {
    return Collections.unmodifiableMap(inPart);
  }

  @Override
  public final List<String> lemmas() {
    return List.copyOf(sentences.keySet());
  }

  @Override
  public final List<String> progressLemmas() {
    return Collections.unmodifiableList(progress);
  }

  @Override
  public final String description(String lemma) {
    return sentences.getOrDefault(lemma, "");
  }
}
