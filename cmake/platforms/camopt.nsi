; SPDX-License-Identifier: MIT
; makensis -DVERSION=… -DFILES=/path -DOUT=/path/camopt-setup.exe camopt.nsi
; FILES: camopt.exe, camopt.html, licenses\*.txt, scenes\*.toml and the folders in it.
; For the user alone: no administrator. /S installs and removes without a question, /D=C:\folder elsewhere.
Target amd64-unicode
Unicode true
Name "camopt"
OutFile "${OUT}"
InstallDir "$LOCALAPPDATA\Programs\camopt"
InstallDirRegKey HKCU "Software\camopt" "folder"
RequestExecutionLevel user
SetCompressor /SOLID lzma
SetDateSave off
!include WinMessages.nsh
!include StrFunc.nsh
${StrRep}
${UnStrRep}
Page license
LicenseData "${FILES}/licenses/LICENSE.camopt.txt"
Page directory
Page instfiles
UninstPage uninstConfirm
UninstPage instfiles
!define UNINSTALL "Software\Microsoft\Windows\CurrentVersion\Uninstall\camopt"

Section
  SetOutPath "$INSTDIR"
  File "${FILES}/camopt.exe"
  File "${FILES}/camopt.html"
  File /r "${FILES}/licenses"
  File /r "${FILES}/scenes"
  WriteUninstaller "$INSTDIR\uninstall.exe"
  CreateShortCut "$SMPROGRAMS\camopt.lnk" "$INSTDIR\camopt.html"
  WriteRegStr HKCU "Software\camopt" "folder" "$INSTDIR"
  WriteRegStr HKCU "${UNINSTALL}" "DisplayName" "camopt"
  WriteRegStr HKCU "${UNINSTALL}" "DisplayVersion" "${VERSION}"
  WriteRegStr HKCU "${UNINSTALL}" "InstallLocation" "$INSTDIR"
  WriteRegStr HKCU "${UNINSTALL}" "UninstallString" '"$INSTDIR\uninstall.exe"'
  WriteRegStr HKCU "${UNINSTALL}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
  WriteRegDWORD HKCU "${UNINSTALL}" "NoModify" 1
  WriteRegDWORD HKCU "${UNINSTALL}" "NoRepair" 1
  ; "camopt solve …" in every console opened from now on. A Path that is longer than NSIS can hold is an error here: it is
  ; left as it is.
  ClearErrors
  ReadRegStr $0 HKCU "Environment" "Path"
  IfErrors done
  StrLen $1 "$0"
  IntCmp $1 900 0 0 done
  ${StrRep} $2 "$0" "$INSTDIR;" ""
  WriteRegExpandStr HKCU "Environment" "Path" "$INSTDIR;$2"
  SendMessage ${HWND_BROADCAST} ${WM_SETTINGCHANGE} 0 "STR:Environment" /TIMEOUT=2000
done:
SectionEnd

Section "Uninstall"
  Delete "$INSTDIR\camopt.exe"
  Delete "$INSTDIR\camopt.html"
  RMDir /r "$INSTDIR\licenses"
  RMDir /r "$INSTDIR\scenes"
  Delete "$INSTDIR\uninstall.exe"
  RMDir "$INSTDIR"
  Delete "$SMPROGRAMS\camopt.lnk"
  ClearErrors
  ReadRegStr $0 HKCU "Environment" "Path"
  IfErrors done
  StrLen $1 "$0"
  IntCmp $1 900 0 0 done
  ${UnStrRep} $2 "$0" "$INSTDIR;" ""
  WriteRegExpandStr HKCU "Environment" "Path" "$2"
  SendMessage ${HWND_BROADCAST} ${WM_SETTINGCHANGE} 0 "STR:Environment" /TIMEOUT=2000
done:
  DeleteRegKey HKCU "${UNINSTALL}"
  DeleteRegKey HKCU "Software\camopt"
SectionEnd
