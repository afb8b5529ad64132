package org.starl.lang.server;

import java.io.InputStream;
import java.io.OutputStream;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import org.eclipse.lsp4j.DidChangeConfigurationParams;
import org.eclipse.lsp4j.DidChangeWatchedFilesParams;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.InitializeResult;
import org.eclipse.lsp4j.ServerCapabilities;
import org.eclipse.lsp4j.ServerInfo;
import org.eclipse.lsp4j.TextDocumentSyncKind;
import org.eclipse.lsp4j.jsonrpc.Launcher;
import org.eclipse.lsp4j.launch.LSPLauncher;
import org.eclipse.lsp4j.services.LanguageClient;
import org.eclipse.lsp4j.services.LanguageServer;
import org.eclipse.lsp4j.services.TextDocumentService;
import org.eclipse.lsp4j.services.WorkspaceService;

/** Serves one editor. */
public final class StarlServer implements LanguageServer {

  private final Documents documents = new Documents();
  private final CompletableFuture<Future<Void>> listening = new CompletableFuture<>();
  private boolean wasShutDown;

  /**
   * Serves the editor at the far end of two streams, until it says that it ends or closes its stream.
   *
   * @return the exit status: 0, or 1 if the editor left without a shutdown
   */
  public static int serve(InputStream in, OutputStream out) throws InterruptedException {
    StarlServer server = new StarlServer();
    Launcher<LanguageClient> launcher = LSPLauncher.createServerLauncher(server, in, out);
    server.documents.connect(launcher.getRemoteProxy());
    Future<Void> listening = launcher.startListening();
    server.listening.complete(listening);
    try {
      listening.get();
    } catch (CancellationException e) {
      return server.wasShutDown ? 0 : 1;
    } catch (ExecutionException e) {
      throw new IllegalStateException("the connection to the editor", e.getCause());
    }
    return server.wasShutDown ? 0 : 1;
  }

  @Override
  public CompletableFuture<InitializeResult> initialize(InitializeParams params) {
    ServerCapabilities can = new ServerCapabilities();
    can.setTextDocumentSync(TextDocumentSyncKind.Full);
    can.setHoverProvider(true);
    can.setDefinitionProvider(true);
    return CompletableFuture.completedFuture(new InitializeResult(can, new ServerInfo("StarL")));
  }

  @Override
  public CompletableFuture<Object> shutdown() {
    wasShutDown = true;
    return CompletableFuture.completedFuture(List.of());
  }

  @Override
  public void exit() {
    listening.join().cancel(true); // whether or not the editor closes its stream
  }

  @Override
  public TextDocumentService getTextDocumentService() {
    return documents;
  }

  @Override
  public WorkspaceService getWorkspaceService() {
    return new WorkspaceService() {
      @Override
      public void didChangeConfiguration(DidChangeConfigurationParams params) {
        // There is nothing to configure.
      }

      @Override
      public void didChangeWatchedFiles(DidChangeWatchedFilesParams params) {
        documents.readAgain();
      }
    };
  }
}
