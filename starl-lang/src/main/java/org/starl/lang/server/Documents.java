package org.starl.lang.server;

import java.net.URI;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.DefinitionParams;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.DiagnosticSeverity;
import org.eclipse.lsp4j.DidChangeTextDocumentParams;
import org.eclipse.lsp4j.DidCloseTextDocumentParams;
import org.eclipse.lsp4j.DidOpenTextDocumentParams;
import org.eclipse.lsp4j.DidSaveTextDocumentParams;
import org.eclipse.lsp4j.Hover;
import org.eclipse.lsp4j.HoverParams;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.LocationLink;
import org.eclipse.lsp4j.MarkupContent;
import org.eclipse.lsp4j.MarkupKind;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.PublishDiagnosticsParams;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.eclipse.lsp4j.services.LanguageClient;
import org.eclipse.lsp4j.services.TextDocumentService;
import org.jspecify.annotations.Nullable;
import org.starl.lang.read.Reference;
import org.starl.lang.read.Source;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Pos;

/** The files that an editor has open, as they stand in it. The editor's thread alone calls it. */
final class Documents implements TextDocumentService {

  private record Open(String text, Source source) {}

  private final Map<String, Open> open = new TreeMap<>();
  private @Nullable LanguageClient client;

  void connect(LanguageClient editor) {
    client = editor;
  }

  /** Reads all open files again: one that they use may have changed. */
  void readAgain() {
    for (Map.Entry<String, Open> each : List.copyOf(open.entrySet())) {
      read(each.getKey(), each.getValue().text());
    }
  }

  @Override
  public void didOpen(DidOpenTextDocumentParams params) {
    read(params.getTextDocument().getUri(), params.getTextDocument().getText());
  }

  @Override
  public void didChange(DidChangeTextDocumentParams params) {
    // Each change has the whole text, as the server has asked for.
    read(params.getTextDocument().getUri(), params.getContentChanges().getLast().getText());
  }

  @Override
  public void didClose(DidCloseTextDocumentParams params) {
    open.remove(params.getTextDocument().getUri());
  }

  @Override
  public void didSave(DidSaveTextDocumentParams params) {
    readAgain();
  }

  @Override
  public CompletableFuture<@Nullable Hover> hover(HoverParams params) {
    Hover hover =
        reference(params.getTextDocument().getUri(), params.getPosition())
            .map(found ->
                new Hover(
                    new MarkupContent(MarkupKind.PLAINTEXT, found.meaning()),
                    range(found.at(), found.name().length())))
            .orElse(null);
    return CompletableFuture.completedFuture(hover);
  }

  @Override
  public CompletableFuture<Either<List<? extends Location>, List<? extends LocationLink>>>
      definition(DefinitionParams params) {
    String uri = params.getTextDocument().getUri();
    List<Location> places = new ArrayList<>();
    reference(uri, params.getPosition())
        .ifPresent(found ->
            places.add(new Location(uri, range(found.declaredAt(), found.name().length()))));
    return CompletableFuture.completedFuture(Either.forLeft(places));
  }

  private void read(String uri, String text) {
    Path path = uri.startsWith("file:") ? Path.of(URI.create(uri)) : null;
    String name = path == null ? uri : path.toString();
    Source source = new SourceReader().look(name, text, path);
    open.put(uri, new Open(text, source));
    if (client != null) {
      List<Diagnostic> errors = new ArrayList<>();
      source
          .errors()
          .forEach(error -> {
            // An error of a file that this one uses is shown at the beginning.
            boolean isHere = error.file().equals(name);
            errors.add(
                new Diagnostic(
                    range(isHere ? error.pos() : new Pos(1, 1), 1),
                    isHere ? error.message() : error.toString(),
                    DiagnosticSeverity.Error,
                    "starl"));
          });
      client.publishDiagnostics(new PublishDiagnosticsParams(uri, errors));
    }
  }

  private Optional<Reference> reference(String uri, Position position) {
    Open document = open.get(uri);
    Pos pos = new Pos(position.getLine() + 1, position.getCharacter() + 1);
    return document == null
        ? Optional.empty()
        : document.source().references().stream().filter(found -> found.covers(pos)).findFirst();
  }

  private static Range range(Pos pos, int length) {
    int line = pos.line() - 1;
    int from = pos.column() - 1;
    return new Range(new Position(line, from), new Position(line, from + length));
  }
}
