package org.starl.lang.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import org.eclipse.lsp4j.DefinitionParams;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.DidOpenTextDocumentParams;
import org.eclipse.lsp4j.HoverParams;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.MessageActionItem;
import org.eclipse.lsp4j.MessageParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.PublishDiagnosticsParams;
import org.eclipse.lsp4j.ShowMessageRequestParams;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.TextDocumentItem;
import org.eclipse.lsp4j.jsonrpc.Launcher;
import org.eclipse.lsp4j.launch.LSPLauncher;
import org.eclipse.lsp4j.services.LanguageClient;
import org.eclipse.lsp4j.services.LanguageServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** An editor and the server, over the protocol itself. */
class StarlServerTest {

  private static final String URI = "untitled:lamp";
  private static final String LAMP =
      """
      automaton Lamp[PIDS]
      type Color = red | green
      state shows: Color
      start shows = red
      action change(i: PIDS)
        eff shows := green
      """;

  private static final String PROGRAM =
      """
      program Turns
      given xid: Text
      uses reg: Registration(xid, {self})
      location out
        do reg.do_register(); goto waiting
      location waiting
        when reg.registered do restart
      """;

  /** What an editor does with what it is told. */
  private static final class Editor implements LanguageClient {
    final BlockingQueue<List<Diagnostic>> errors = new ArrayBlockingQueue<>(100);

    @Override
    public void publishDiagnostics(PublishDiagnosticsParams told) {
      errors.add(told.getDiagnostics());
    }

    @Override
    public void telemetryEvent(Object object) {}

    @Override
    public void showMessage(MessageParams message) {}

    @Override
    public CompletableFuture<MessageActionItem> showMessageRequest(
        ShowMessageRequestParams request) {
      return CompletableFuture.completedFuture(null);
    }

    @Override
    public void logMessage(MessageParams message) {}
  }

  private final Editor editor = new Editor();
  private LanguageServer server;
  private PipedOutputStream toServer;
  private Future<Integer> status;

  @BeforeEach
  void connect() throws Exception {
    toServer = new PipedOutputStream();
    PipedInputStream atServer = new PipedInputStream(toServer, 1 << 16);
    PipedOutputStream toEditor = new PipedOutputStream();
    PipedInputStream atEditor = new PipedInputStream(toEditor, 1 << 16);
    FutureTask<Integer> serving = new FutureTask<>(() -> StarlServer.serve(atServer, toEditor));
    status = serving;
    Thread.ofPlatform().daemon().start(serving);
    Launcher<LanguageServer> launcher =
        LSPLauncher.createClientLauncher(editor, atEditor, toServer);
    launcher.startListening();
    server = launcher.getRemoteProxy();
    server.initialize(new InitializeParams()).get(60, TimeUnit.SECONDS);
  }

  @AfterEach
  void close() throws IOException {
    toServer.close();
  }

  private List<Diagnostic> open(String text) throws InterruptedException {
    server
        .getTextDocumentService()
        .didOpen(new DidOpenTextDocumentParams(new TextDocumentItem(URI, "starl", 1, text)));
    return editor.errors.poll(60, TimeUnit.SECONDS);
  }

  private static TextDocumentIdentifier file() {
    return new TextDocumentIdentifier(URI);
  }

  @Test
  void errorIsShownAtItsPlace() throws Exception {
    assertThat(open(LAMP)).isEmpty();
    List<Diagnostic> errors = open(LAMP.replace("shows := green", "shows := grean"));
    assertThat(errors).hasSize(1);
    assertThat(errors.getFirst().getMessage())
        .startsWith("'grean' is not known here; expected green");
    assertThat(errors.getFirst().getRange().getStart()).isEqualTo(new Position(5, 15));
  }

  @Test
  void hoverShowsTheType() throws Exception {
    open(LAMP);
    assertThat(hover(5, 7)).isEqualTo("shows: Color");
  }

  @Test
  void definitionIsTheDeclaration() throws Exception {
    open(LAMP);
    assertThat(definition(5, 16)).isEqualTo(new Position(1, 19));
  }

  @Test
  void programIsKnownLikeAnAutomaton() throws Exception {
    assertThat(open(PROGRAM)).isEmpty();
    assertThat(hover(2, 12))
        .isEqualTo("primitive Registration(xid: Text, acceptors: set[PIDS]) is Registration_decls");
    assertThat(hover(4, 6)).isEqualTo("reg: Registration");
    assertThat(hover(4, 11)).isEqualTo("do_register()");
    assertThat(hover(6, 12)).isEqualTo("registered: bool");
    assertThat(definition(6, 12)).isEqualTo(new Position(2, 5));
    assertThat(definition(4, 30)).isEqualTo(new Position(5, 9));
    assertThat(open(PROGRAM.replace("reg.registered", "reg.ready"))).hasSize(1);
  }

  private String hover(int line, int column) throws Exception {
    return server
        .getTextDocumentService()
        .hover(new HoverParams(file(), new Position(line, column)))
        .get(60, TimeUnit.SECONDS)
        .getContents()
        .getRight()
        .getValue();
  }

  private Position definition(int line, int column) throws Exception {
    return server
        .getTextDocumentService()
        .definition(new DefinitionParams(file(), new Position(line, column)))
        .get(60, TimeUnit.SECONDS)
        .getLeft()
        .getFirst()
        .getRange()
        .getStart();
  }

  @Test
  void serverEndsAtExitThoughItsInputStaysOpen() throws Exception {
    server.shutdown().get(60, TimeUnit.SECONDS);
    server.exit();
    assertThat(status.get(60, TimeUnit.SECONDS)).isZero();
  }

  @Test
  void serverEndsWithTheEditor() throws Exception {
    server.shutdown().get(60, TimeUnit.SECONDS);
    server.exit();
    toServer.close();
    assertThat(status.get(60, TimeUnit.SECONDS)).isZero();
  }
}
