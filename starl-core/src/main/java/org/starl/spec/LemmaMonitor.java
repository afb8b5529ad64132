package org.starl.spec;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A monitor with a table of its lemmas and their descriptions. */
public abstract class LemmaMonitor implements Monitor {

  private final Map<String, String> sentences = new LinkedHashMap<>();

  /** Adds a lemma, and the sentence that explains it to a user. For constructors. */
  protected final void lemma(String name, String sentence) {
    sentences.put(name, sentence);
  }

  @Override
  public final List<String> lemmas() {
    return List.copyOf(sentences.keySet());
  }

  @Override
  public final String description(String lemma) {
    return sentences.getOrDefault(lemma, "");
  }
}
