(()=>{var Ym=0,Cf=1,$m=2;var Pr=1,Zm=2,Oo=3,ur=0,ii=1,Ii=2,Ir=0,Bo=1,Rf=2,Pf=3,If=4,Jm=5;var Lr=100,jm=101,Km=102,Qm=103,eg=104,tg=200,ng=201,ig=202,sg=203,Lf=204,Nf=205,rg=206,og=207,ag=208,lg=209,cg=210,ug=211,hg=212,fg=213,dg=214,Sc=0,Mc=1,bc=2,To=3,wc=4,Ec=5,Ac=6,Tc=7,eu=0,pg=1,mg=2,ps=0,Df=1,Uf=2,Ff=3,Of=4,Bf=5,kf=6,Za=7;var zf=300,Nr=301,ko=302,tu=303,nu=304,Cc=1e3,hs=1001,Rc=1002,kn=1003,gg=1004;var Ja=1005;var ni=1006,iu=1007;var Fs=1008;var Xn=1009,Gf=1010,Vf=1011,zo=1012,su=1013,Zi=1014,Li=1015,Ji=1016,ru=1017,ou=1018,Dr=1020,Hf=35902,Wf=35899,Xf=1021,qf=1022,ui=1023,Is=1026,Os=1027,Go=1028,au=1029,ji=1030,lu=1031;var cu=1033,ja=33776,Ka=33777,Qa=33778,el=33779,uu=35840,hu=35841,fu=35842,du=35843,pu=36196,mu=37492,gu=37496,_u=37488,xu=37489,tl=37490,vu=37491,yu=37808,Su=37809,Mu=37810,bu=37811,wu=37812,Eu=37813,Au=37814,Tu=37815,Cu=37816,Ru=37817,Pu=37818,Iu=37819,Lu=37820,Nu=37821,Du=36492,Uu=36494,Fu=36495,Ou=36283,Bu=36284,nl=36285,ku=36286;var Aa=2300,Pc=2301,vc=2302,yf=2303,Sf=2400,Mf=2401,bf=2402;var _g=3200;var il=0,xg=1,Bs="",ei="srgb",Ta="srgb-linear",Ca="linear",Tt="srgb";var yc=7680;var vg=519,yg=512,Sg=513,Mg=514,Yf=515,bg=516,wg=517,$f=518,Zf=519,Eg=35044;var Jf="300 es",Ri=2e3,Co=2001;function jS(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function KS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ra(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Ag(){let n=Ra("canvas");return n.style.display="block",n}var gm={},Ro=null;function jf(...n){let e="THREE."+n.shift();Ro?Ro("log",e,...n):console.log(e,...n)}function Tg(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ze(...n){n=Tg(n);let e="THREE."+n.shift();if(Ro)Ro("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Qe(...n){n=Tg(n);let e="THREE."+n.shift();if(Ro)Ro("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Ea(...n){let e=n.join(" ");e in gm||(gm[e]=!0,Ze(...n))}function Cg(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var Rg={[Sc]:Sc,[bc]:Ac,[wc]:wc,[To]:Ec,[Mc]:Mc,[Ac]:bc,[Tc]:Tc,[Ec]:To},Xi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Hn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Jh=Math.PI/180,Ic=180/Math.PI;function sl(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Hn[n&255]+Hn[n>>8&255]+Hn[n>>16&255]+Hn[n>>24&255]+"-"+Hn[e&255]+Hn[e>>8&255]+"-"+Hn[e>>16&15|64]+Hn[e>>24&255]+"-"+Hn[t&63|128]+Hn[t>>8&255]+"-"+Hn[t>>16&255]+Hn[t>>24&255]+Hn[i&255]+Hn[i>>8&255]+Hn[i>>16&255]+Hn[i>>24&255]).toLowerCase()}function yt(n,e,t){return Math.max(e,Math.min(t,n))}function QS(n,e){return(n%e+e)%e}function jh(n,e,t){return(1-t)*n+t*e}function Pg(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Kf(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function eM(n,e){if(e.constructor===Float32Array)return n;let t=Kf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function tM(n,e){if(e.constructor===Float32Array)return n;let t=Kf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var lt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(yt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(yt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Et=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],p=r[o+1],g=r[o+2],y=r[o+3];if(f!==y||l!==h||c!==p||u!==g){let d=l*h+c*p+u*g+f*y;d<0&&(h=-h,p=-p,g=-g,y=-y,d=-d);let m=1-a;if(d<.9995){let v=Math.acos(d),T=Math.sin(v);m=Math.sin(m*v)/T,a=Math.sin(a*v)/T,l=l*m+h*a,c=c*m+p*a,u=u*m+g*a,f=f*m+y*a}else{l=l*m+h*a,c=c*m+p*a,u=u*m+g*a,f=f*m+y*a;let v=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=v,c*=v,u*=v,f*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],p=r[o+2],g=r[o+3];return e[t]=a*g+u*f+l*p-c*h,e[t+1]=l*g+u*h+c*f-a*p,e[t+2]=c*g+u*p+a*h-l*f,e[t+3]=u*g-a*f-l*h-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),p=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*p*g,this._y=c*p*f-h*u*g,this._z=c*u*g+h*p*f,this._w=c*u*f-h*p*g;break;case"YXZ":this._x=h*u*f+c*p*g,this._y=c*p*f-h*u*g,this._z=c*u*g-h*p*f,this._w=c*u*f+h*p*g;break;case"ZXY":this._x=h*u*f-c*p*g,this._y=c*p*f+h*u*g,this._z=c*u*g+h*p*f,this._w=c*u*f-h*p*g;break;case"ZYX":this._x=h*u*f-c*p*g,this._y=c*p*f+h*u*g,this._z=c*u*g-h*p*f,this._w=c*u*f+h*p*g;break;case"YZX":this._x=h*u*f+c*p*g,this._y=c*p*f+h*u*g,this._z=c*u*g-h*p*f,this._w=c*u*f-h*p*g;break;case"XZY":this._x=h*u*f-c*p*g,this._y=c*p*f-h*u*g,this._z=c*u*g+h*p*f,this._w=c*u*f+h*p*g;break;default:Ze("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=i+a+f;if(h>0){let p=.5/Math.sqrt(h+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>f){let p=2*Math.sqrt(1+i-a-f);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>f){let p=2*Math.sqrt(1+a-i-f);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+f-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(yt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},B=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(_m.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(_m.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(yt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Kh.copy(this).projectOnVector(e),this.sub(Kh)}reflect(e){return this.sub(Kh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(yt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Kh=new B,_m=new Et,tt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],p=i[5],g=i[8],y=s[0],d=s[3],m=s[6],v=s[1],T=s[4],S=s[7],C=s[2],A=s[5],_=s[8];return r[0]=o*y+a*v+l*C,r[3]=o*d+a*T+l*A,r[6]=o*m+a*S+l*_,r[1]=c*y+u*v+f*C,r[4]=c*d+u*T+f*A,r[7]=c*m+u*S+f*_,r[2]=h*y+p*v+g*C,r[5]=h*d+p*T+g*A,r[8]=h*m+p*S+g*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,h=a*l-u*r,p=c*r-o*l,g=t*f+i*h+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=f*y,e[1]=(s*c-u*i)*y,e[2]=(a*i-s*o)*y,e[3]=h*y,e[4]=(u*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=p*y,e[7]=(i*l-c*t)*y,e[8]=(o*t-i*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Ea("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Qh.makeScale(e,t)),this}rotate(e){return Ea("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Qh.makeRotation(-e)),this}translate(e,t){return Ea("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Qh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Qh=new tt,xm=new tt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),vm=new tt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function nM(){let n={enabled:!0,workingColorSpace:Ta,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Tt&&(s.r=Ps(s.r),s.g=Ps(s.g),s.b=Ps(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Tt&&(s.r=Ao(s.r),s.g=Ao(s.g),s.b=Ao(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Bs?Ca:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ta]:{primaries:e,whitePoint:i,transfer:Ca,toXYZ:xm,fromXYZ:vm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ei},outputColorSpaceConfig:{drawingBufferColorSpace:ei}},[ei]:{primaries:e,whitePoint:i,transfer:Tt,toXYZ:xm,fromXYZ:vm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ei}}}),n}var _t=nM();function Ps(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Ao(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var ho,Lc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{ho===void 0&&(ho=Ra("canvas")),ho.width=e.width,ho.height=e.height;let s=ho.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=ho}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ra("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ps(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Ps(t[i]/255)*255):t[i]=Ps(t[i]);return{data:t,width:e.width,height:e.height}}else return Ze("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},iM=0,Po=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:iM++}),this.uuid=sl(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ef(s[o].image)):r.push(ef(s[o]))}else r=ef(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function ef(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Lc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ze("Texture: Unable to serialize Texture."),{})}var sM=0,tf=new B,li=class n extends Xi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=hs,s=hs,r=ni,o=Fs,a=ui,l=Xn,c=n.DEFAULT_ANISOTROPY,u=Bs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:sM++}),this.uuid=sl(),this.name="",this.source=new Po(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new lt(0,0),this.repeat=new lt(1,1),this.center=new lt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new tt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(tf).x}get height(){return this.source.getSize(tf).y}get depth(){return this.source.getSize(tf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ze(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==zf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Cc:e.x=e.x-Math.floor(e.x);break;case hs:e.x=e.x<0?0:1;break;case Rc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Cc:e.y=e.y-Math.floor(e.y);break;case hs:e.y=e.y<0?0:1;break;case Rc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};li.DEFAULT_IMAGE=null;li.DEFAULT_MAPPING=zf;li.DEFAULT_ANISOTROPY=1;var Ht=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],p=l[5],g=l[9],y=l[2],d=l[6],m=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-y)<.01&&Math.abs(g-d)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+y)<.1&&Math.abs(g+d)<.1&&Math.abs(c+p+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,S=(p+1)/2,C=(m+1)/2,A=(u+h)/4,_=(f+y)/4,w=(g+d)/4;return T>S&&T>C?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=A/i,r=_/i):S>C?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=A/s,r=w/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=_/r,s=w/r),this.set(i,s,r,t),this}let v=Math.sqrt((d-g)*(d-g)+(f-y)*(f-y)+(h-u)*(h-u));return Math.abs(v)<.001&&(v=1),this.x=(d-g)/v,this.y=(f-y)/v,this.z=(h-u)/v,this.w=Math.acos((c+p+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this.w=yt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this.w=yt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(yt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Nc=class extends Xi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ni,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Ht(0,0,e,t),this.scissorTest=!1,this.viewport=new Ht(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new li({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ni,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Po(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},vi=class extends Nc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Pa=class extends li{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=kn,this.minFilter=kn,this.wrapR=hs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Dc=class extends li{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=kn,this.minFilter=kn,this.wrapR=hs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var xt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,f,h,p,g,y,d){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,h,p,g,y,d)}set(e,t,i,s,r,o,a,l,c,u,f,h,p,g,y,d){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=f,m[14]=h,m[3]=p,m[7]=g,m[11]=y,m[15]=d,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/fo.setFromMatrixColumn(e,0).length(),r=1/fo.setFromMatrixColumn(e,1).length(),o=1/fo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,p=o*f,g=a*u,y=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=p+g*c,t[5]=h-y*c,t[9]=-a*l,t[2]=y-h*c,t[6]=g+p*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,p=l*f,g=c*u,y=c*f;t[0]=h+y*a,t[4]=g*a-p,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=p*a-g,t[6]=y+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,p=l*f,g=c*u,y=c*f;t[0]=h-y*a,t[4]=-o*f,t[8]=g+p*a,t[1]=p+g*a,t[5]=o*u,t[9]=y-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,p=o*f,g=a*u,y=a*f;t[0]=l*u,t[4]=g*c-p,t[8]=h*c+y,t[1]=l*f,t[5]=y*c+h,t[9]=p*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,p=o*c,g=a*l,y=a*c;t[0]=l*u,t[4]=y-h*f,t[8]=g*f+p,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*f+g,t[10]=h-y*f}else if(e.order==="XZY"){let h=o*l,p=o*c,g=a*l,y=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+y,t[5]=o*u,t[9]=p*f-g,t[2]=g*f-p,t[6]=a*u,t[10]=y*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(rM,e,oM)}lookAt(e,t,i){let s=this.elements;return _i.subVectors(e,t),_i.lengthSq()===0&&(_i.z=1),_i.normalize(),Ks.crossVectors(i,_i),Ks.lengthSq()===0&&(Math.abs(i.z)===1?_i.x+=1e-4:_i.z+=1e-4,_i.normalize(),Ks.crossVectors(i,_i)),Ks.normalize(),Jl.crossVectors(_i,Ks),s[0]=Ks.x,s[4]=Jl.x,s[8]=_i.x,s[1]=Ks.y,s[5]=Jl.y,s[9]=_i.y,s[2]=Ks.z,s[6]=Jl.z,s[10]=_i.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],p=i[13],g=i[2],y=i[6],d=i[10],m=i[14],v=i[3],T=i[7],S=i[11],C=i[15],A=s[0],_=s[4],w=s[8],U=s[12],L=s[1],I=s[5],k=s[9],W=s[13],N=s[2],V=s[6],Y=s[10],G=s[14],ae=s[3],q=s[7],K=s[11],ne=s[15];return r[0]=o*A+a*L+l*N+c*ae,r[4]=o*_+a*I+l*V+c*q,r[8]=o*w+a*k+l*Y+c*K,r[12]=o*U+a*W+l*G+c*ne,r[1]=u*A+f*L+h*N+p*ae,r[5]=u*_+f*I+h*V+p*q,r[9]=u*w+f*k+h*Y+p*K,r[13]=u*U+f*W+h*G+p*ne,r[2]=g*A+y*L+d*N+m*ae,r[6]=g*_+y*I+d*V+m*q,r[10]=g*w+y*k+d*Y+m*K,r[14]=g*U+y*W+d*G+m*ne,r[3]=v*A+T*L+S*N+C*ae,r[7]=v*_+T*I+S*V+C*q,r[11]=v*w+T*k+S*Y+C*K,r[15]=v*U+T*W+S*G+C*ne,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],p=e[14],g=e[3],y=e[7],d=e[11],m=e[15],v=l*p-c*h,T=a*p-c*f,S=a*h-l*f,C=o*p-c*u,A=o*h-l*u,_=o*f-a*u;return t*(y*v-d*T+m*S)-i*(g*v-d*C+m*A)+s*(g*T-y*C+m*_)-r*(g*S-y*A+d*_)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],p=e[11],g=e[12],y=e[13],d=e[14],m=e[15],v=t*a-i*o,T=t*l-s*o,S=t*c-r*o,C=i*l-s*a,A=i*c-r*a,_=s*c-r*l,w=u*y-f*g,U=u*d-h*g,L=u*m-p*g,I=f*d-h*y,k=f*m-p*y,W=h*m-p*d,N=v*W-T*k+S*I+C*L-A*U+_*w;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/N;return e[0]=(a*W-l*k+c*I)*V,e[1]=(s*k-i*W-r*I)*V,e[2]=(y*_-d*A+m*C)*V,e[3]=(h*A-f*_-p*C)*V,e[4]=(l*L-o*W-c*U)*V,e[5]=(t*W-s*L+r*U)*V,e[6]=(d*S-g*_-m*T)*V,e[7]=(u*_-h*S+p*T)*V,e[8]=(o*k-a*L+c*w)*V,e[9]=(i*L-t*k-r*w)*V,e[10]=(g*A-y*S+m*v)*V,e[11]=(f*S-u*A-p*v)*V,e[12]=(a*U-o*I-l*w)*V,e[13]=(t*I-i*U+s*w)*V,e[14]=(y*T-g*C-d*v)*V,e[15]=(u*C-f*T+h*v)*V,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,h=r*c,p=r*u,g=r*f,y=o*u,d=o*f,m=a*f,v=l*c,T=l*u,S=l*f,C=i.x,A=i.y,_=i.z;return s[0]=(1-(y+m))*C,s[1]=(p+S)*C,s[2]=(g-T)*C,s[3]=0,s[4]=(p-S)*A,s[5]=(1-(h+m))*A,s[6]=(d+v)*A,s[7]=0,s[8]=(g+T)*_,s[9]=(d-v)*_,s[10]=(1-(h+y))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=fo.set(s[0],s[1],s[2]).length(),a=fo.set(s[4],s[5],s[6]).length(),l=fo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Gi.copy(this);let c=1/o,u=1/a,f=1/l;return Gi.elements[0]*=c,Gi.elements[1]*=c,Gi.elements[2]*=c,Gi.elements[4]*=u,Gi.elements[5]*=u,Gi.elements[6]*=u,Gi.elements[8]*=f,Gi.elements[9]*=f,Gi.elements[10]*=f,t.setFromRotationMatrix(Gi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ri,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),p=(i+s)/(i-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===Ri)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Co)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ri,l=!1){let c=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),p=-(i+s)/(i-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===Ri)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===Co)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},fo=new B,Gi=new xt,rM=new B(0,0,0),oM=new B(1,1,1),Ks=new B,Jl=new B,_i=new B,ym=new xt,Sm=new Et,Pi=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(yt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-yt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(yt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-yt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(yt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-yt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Ze("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return ym.makeRotationFromQuaternion(e),this.setFromRotationMatrix(ym,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Sm.setFromEuler(this),this.setFromQuaternion(Sm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Pi.DEFAULT_ORDER="XYZ";var Io=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},aM=0,Mm=new B,po=new Et,Es=new xt,jl=new B,xa=new B,lM=new B,cM=new Et,bm=new B(1,0,0),wm=new B(0,1,0),Em=new B(0,0,1),Am={type:"added"},uM={type:"removed"},mo={type:"childadded",child:null},nf={type:"childremoved",child:null},gn=class n extends Xi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:aM++}),this.uuid=sl(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new B,t=new Pi,i=new Et,s=new B(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new xt},normalMatrix:{value:new tt}}),this.matrix=new xt,this.matrixWorld=new xt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Io,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return po.setFromAxisAngle(e,t),this.quaternion.multiply(po),this}rotateOnWorldAxis(e,t){return po.setFromAxisAngle(e,t),this.quaternion.premultiply(po),this}rotateX(e){return this.rotateOnAxis(bm,e)}rotateY(e){return this.rotateOnAxis(wm,e)}rotateZ(e){return this.rotateOnAxis(Em,e)}translateOnAxis(e,t){return Mm.copy(e).applyQuaternion(this.quaternion),this.position.add(Mm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(bm,e)}translateY(e){return this.translateOnAxis(wm,e)}translateZ(e){return this.translateOnAxis(Em,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Es.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?jl.copy(e):jl.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),xa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Es.lookAt(xa,jl,this.up):Es.lookAt(jl,xa,this.up),this.quaternion.setFromRotationMatrix(Es),s&&(Es.extractRotation(s.matrixWorld),po.setFromRotationMatrix(Es),this.quaternion.premultiply(po.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Am),mo.child=e,this.dispatchEvent(mo),mo.child=null):Qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(uM),nf.child=e,this.dispatchEvent(nf),nf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Es.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Es.multiply(e.parent.matrixWorld)),e.applyMatrix4(Es),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Am),mo.child=e,this.dispatchEvent(mo),mo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(xa,e,lM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(xa,cM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),p=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),p.length>0&&(i.animations=p),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};gn.DEFAULT_UP=new B(0,1,0);gn.DEFAULT_MATRIX_AUTO_UPDATE=!0;gn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var cn=class extends gn{constructor(){super(),this.isGroup=!0,this.type="Group"}},hM={type:"move"},Lo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new cn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new cn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new B,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new B),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new cn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new B,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new B,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let d=t.getJointPose(y,i),m=this._getHandJoint(c,y);d!==null&&(m.matrix.fromArray(d.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=d.radius),m.visible=d!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),p=.02,g=.005;c.inputState.pinching&&h>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(hM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new cn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Ig={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Qs={h:0,s:0,l:0},Kl={h:0,s:0,l:0};function sf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var qe=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ei){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,_t.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=_t.workingColorSpace){return this.r=e,this.g=t,this.b=i,_t.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=_t.workingColorSpace){if(e=QS(e,1),t=yt(t,0,1),i=yt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=sf(o,r,e+1/3),this.g=sf(o,r,e),this.b=sf(o,r,e-1/3)}return _t.colorSpaceToWorking(this,s),this}setStyle(e,t=ei){function i(r){r!==void 0&&parseFloat(r)<1&&Ze("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ze("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ze("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ei){let i=Ig[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ze("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ps(e.r),this.g=Ps(e.g),this.b=Ps(e.b),this}copyLinearToSRGB(e){return this.r=Ao(e.r),this.g=Ao(e.g),this.b=Ao(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ei){return _t.workingToColorSpace(Wn.copy(this),e),Math.round(yt(Wn.r*255,0,255))*65536+Math.round(yt(Wn.g*255,0,255))*256+Math.round(yt(Wn.b*255,0,255))}getHexString(e=ei){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=_t.workingColorSpace){_t.workingToColorSpace(Wn.copy(this),t);let i=Wn.r,s=Wn.g,r=Wn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=_t.workingColorSpace){return _t.workingToColorSpace(Wn.copy(this),t),e.r=Wn.r,e.g=Wn.g,e.b=Wn.b,e}getStyle(e=ei){_t.workingToColorSpace(Wn.copy(this),e);let t=Wn.r,i=Wn.g,s=Wn.b;return e!==ei?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Qs),this.setHSL(Qs.h+e,Qs.s+t,Qs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Qs),e.getHSL(Kl);let i=jh(Qs.h,Kl.h,t),s=jh(Qs.s,Kl.s,t),r=jh(Qs.l,Kl.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Wn=new qe;qe.NAMES=Ig;var Ia=class extends gn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Pi,this.environmentIntensity=1,this.environmentRotation=new Pi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Vi=new B,As=new B,rf=new B,Ts=new B,go=new B,_o=new B,Tm=new B,of=new B,af=new B,lf=new B,cf=new Ht,uf=new Ht,hf=new Ht,ir=class n{constructor(e=new B,t=new B,i=new B){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Vi.subVectors(e,t),s.cross(Vi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Vi.subVectors(s,t),As.subVectors(i,t),rf.subVectors(e,t);let o=Vi.dot(Vi),a=Vi.dot(As),l=Vi.dot(rf),c=As.dot(As),u=As.dot(rf),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,p=(c*l-a*u)*h,g=(o*u-a*l)*h;return r.set(1-p-g,g,p)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Ts)===null?!1:Ts.x>=0&&Ts.y>=0&&Ts.x+Ts.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Ts)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ts.x),l.addScaledVector(o,Ts.y),l.addScaledVector(a,Ts.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return cf.setScalar(0),uf.setScalar(0),hf.setScalar(0),cf.fromBufferAttribute(e,t),uf.fromBufferAttribute(e,i),hf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(cf,r.x),o.addScaledVector(uf,r.y),o.addScaledVector(hf,r.z),o}static isFrontFacing(e,t,i,s){return Vi.subVectors(i,t),As.subVectors(e,t),Vi.cross(As).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Vi.subVectors(this.c,this.b),As.subVectors(this.a,this.b),Vi.cross(As).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;go.subVectors(s,i),_o.subVectors(r,i),of.subVectors(e,i);let l=go.dot(of),c=_o.dot(of);if(l<=0&&c<=0)return t.copy(i);af.subVectors(e,s);let u=go.dot(af),f=_o.dot(af);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(go,o);lf.subVectors(e,r);let p=go.dot(lf),g=_o.dot(lf);if(g>=0&&p<=g)return t.copy(r);let y=p*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(i).addScaledVector(_o,a);let d=u*g-p*f;if(d<=0&&f-u>=0&&p-g>=0)return Tm.subVectors(r,s),a=(f-u)/(f-u+(p-g)),t.copy(s).addScaledVector(Tm,a);let m=1/(d+y+h);return o=y*m,a=h*m,t.copy(i).addScaledVector(go,o).addScaledVector(_o,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},fs=class{constructor(e=new B(1/0,1/0,1/0),t=new B(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Hi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Hi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Hi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Hi):Hi.fromBufferAttribute(r,o),Hi.applyMatrix4(e.matrixWorld),this.expandByPoint(Hi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ql.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Ql.copy(i.boundingBox)),Ql.applyMatrix4(e.matrixWorld),this.union(Ql)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Hi),Hi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(va),ec.subVectors(this.max,va),xo.subVectors(e.a,va),vo.subVectors(e.b,va),yo.subVectors(e.c,va),er.subVectors(vo,xo),tr.subVectors(yo,vo),wr.subVectors(xo,yo);let t=[0,-er.z,er.y,0,-tr.z,tr.y,0,-wr.z,wr.y,er.z,0,-er.x,tr.z,0,-tr.x,wr.z,0,-wr.x,-er.y,er.x,0,-tr.y,tr.x,0,-wr.y,wr.x,0];return!ff(t,xo,vo,yo,ec)||(t=[1,0,0,0,1,0,0,0,1],!ff(t,xo,vo,yo,ec))?!1:(tc.crossVectors(er,tr),t=[tc.x,tc.y,tc.z],ff(t,xo,vo,yo,ec))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Hi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Hi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Cs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Cs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Cs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Cs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Cs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Cs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Cs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Cs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Cs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Cs=[new B,new B,new B,new B,new B,new B,new B,new B],Hi=new B,Ql=new fs,xo=new B,vo=new B,yo=new B,er=new B,tr=new B,wr=new B,va=new B,ec=new B,tc=new B,Er=new B;function ff(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Er.fromArray(n,r);let a=s.x*Math.abs(Er.x)+s.y*Math.abs(Er.y)+s.z*Math.abs(Er.z),l=e.dot(Er),c=t.dot(Er),u=i.dot(Er);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var wn=new B,nc=new lt,fM=0,mn=class extends Xi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:fM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Eg,this.updateRanges=[],this.gpuType=Li,this.version=0,this._normalizationScale=e!==void 0?Kf(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)nc.fromBufferAttribute(this,t),nc.applyMatrix3(e),this.setXY(t,nc.x,nc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyMatrix3(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyMatrix4(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyNormalMatrix(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.transformDirection(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):eM(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):tM(e,this.array)}};var La=class extends mn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Na=class extends mn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Dt=class extends mn{constructor(e,t,i){super(new Float32Array(e),t,i)}},dM=new fs,ya=new B,df=new B,Ls=class{constructor(e=new B,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):dM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ya.subVectors(e,this.center);let t=ya.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(ya,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(df.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ya.copy(e.center).add(df)),this.expandByPoint(ya.copy(e.center).sub(df))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},pM=0,Ci=new xt,pf=new gn,So=new B,xi=new fs,Sa=new fs,Bn=new B,_n=class n extends Xi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:pM++}),this.uuid=sl(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(jS(e)?Na:La)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new tt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ci.makeRotationFromQuaternion(e),this.applyMatrix4(Ci),this}rotateX(e){return Ci.makeRotationX(e),this.applyMatrix4(Ci),this}rotateY(e){return Ci.makeRotationY(e),this.applyMatrix4(Ci),this}rotateZ(e){return Ci.makeRotationZ(e),this.applyMatrix4(Ci),this}translate(e,t,i){return Ci.makeTranslation(e,t,i),this.applyMatrix4(Ci),this}scale(e,t,i){return Ci.makeScale(e,t,i),this.applyMatrix4(Ci),this}lookAt(e){return pf.lookAt(e),pf.updateMatrix(),this.applyMatrix4(pf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(So).negate(),this.translate(So.x,So.y,So.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Dt(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ze("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new fs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new B(-1/0,-1/0,-1/0),new B(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];xi.setFromBufferAttribute(r),this.morphTargetsRelative?(Bn.addVectors(this.boundingBox.min,xi.min),this.boundingBox.expandByPoint(Bn),Bn.addVectors(this.boundingBox.max,xi.max),this.boundingBox.expandByPoint(Bn)):(this.boundingBox.expandByPoint(xi.min),this.boundingBox.expandByPoint(xi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ls);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new B,1/0);return}if(e){let i=this.boundingSphere.center;if(xi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Sa.setFromBufferAttribute(a),this.morphTargetsRelative?(Bn.addVectors(xi.min,Sa.min),xi.expandByPoint(Bn),Bn.addVectors(xi.max,Sa.max),xi.expandByPoint(Bn)):(xi.expandByPoint(Sa.min),xi.expandByPoint(Sa.max))}xi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Bn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Bn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Bn.fromBufferAttribute(a,c),l&&(So.fromBufferAttribute(e,c),Bn.add(So)),s=Math.max(s,i.distanceToSquared(Bn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new mn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new B,l[U]=new B;let u=new B,f=new B,h=new B,p=new lt,g=new lt,y=new lt,d=new B,m=new B;function v(U,L,I){c[U]=c[L]=c[I]=1,u.fromBufferAttribute(i,U),f.fromBufferAttribute(i,L),h.fromBufferAttribute(i,I),p.fromBufferAttribute(r,U),g.fromBufferAttribute(r,L),y.fromBufferAttribute(r,I),f.sub(u),h.sub(u),g.sub(p),y.sub(p);let k=1/(g.x*y.y-y.x*g.y);isFinite(k)&&(d.copy(f).multiplyScalar(y.y).addScaledVector(h,-g.y).multiplyScalar(k),m.copy(h).multiplyScalar(g.x).addScaledVector(f,-y.x).multiplyScalar(k),a[U].add(d),a[L].add(d),a[I].add(d),l[U].add(m),l[L].add(m),l[I].add(m))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let U=0,L=T.length;U<L;++U){let I=T[U],k=I.start,W=I.count;for(let N=k,V=k+W;N<V;N+=3)v(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let S=new B,C=new B,A=new B,_=new B;function w(U){A.fromBufferAttribute(s,U),_.copy(A);let L=a[U];S.copy(L),S.sub(A.multiplyScalar(A.dot(L))).normalize(),C.crossVectors(_,L);let k=C.dot(l[U])<0?-1:1;o.setXYZW(U,S.x,S.y,S.z,k)}for(let U=0,L=i.count;U<L;++U)c[U]&&w(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new mn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,p=i.count;h<p;h++)i.setXYZ(h,0,0,0);let s=new B,r=new B,o=new B,a=new B,l=new B,c=new B,u=new B,f=new B;if(e)for(let h=0,p=e.count;h<p;h+=3){let g=e.getX(h+0),y=e.getX(h+1),d=e.getX(h+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,d),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,d),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(d,c.x,c.y,c.z)}else for(let h=0,p=t.count;h<p;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Bn.fromBufferAttribute(e,t),Bn.normalize(),e.setXYZ(t,Bn.x,Bn.y,Bn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),p=0,g=0;for(let y=0,d=l.length;y<d;y++){a.isInterleavedBufferAttribute?p=l[y]*a.data.stride+a.offset:p=l[y]*u;for(let m=0;m<u;m++)h[g++]=c[p++]}return new mn(h,u,f)}if(this.index===null)return Ze("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],p=e(h,i);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let p=c[f];u.push(p.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,p=f.length;h<p;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var mf=new B,mM=new B,gM=new tt,Wi=class{constructor(e=new B(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=mf.subVectors(i,t).cross(mM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(mf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||gM.getNormalMatrix(e),s=this.coplanarPoint(mf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},_M=0,qi=class extends Xi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:_M++}),this.uuid=sl(),this.name="",this.type="Material",this.blending=Bo,this.side=ur,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Lf,this.blendDst=Nf,this.blendEquation=Lr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new qe(0,0,0),this.blendAlpha=0,this.depthFunc=To,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=vg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=yc,this.stencilZFail=yc,this.stencilZPass=yc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ze(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new qe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Wi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new lt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new lt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Rs=new B,gf=new B,ic=new B,sc=new B,No=class{constructor(e=new B,t=new B(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Rs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Rs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Rs.copy(this.origin).addScaledVector(this.direction,t),Rs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){gf.copy(e).add(t).multiplyScalar(.5),ic.copy(t).sub(e).normalize(),sc.copy(this.origin).sub(gf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(ic),a=sc.dot(this.direction),l=-sc.dot(ic),c=sc.lengthSq(),u=Math.abs(1-o*o),f,h,p,g;if(u>0)if(f=o*l-a,h=o*a-l,g=r*u,f>=0)if(h>=-g)if(h<=g){let y=1/u;f*=y,h*=y,p=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),p=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),p=-f*f+h*(h+2*l)+c;else h<=-g?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),p=-f*f+h*(h+2*l)+c):h<=g?(f=0,h=Math.min(Math.max(-r,-l),r),p=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),p=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),p=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(gf).addScaledVector(ic,h),p}intersectSphere(e,t){if(e.radius<0)return null;Rs.subVectors(e.center,this.origin);let i=Rs.dot(this.direction),s=Rs.dot(Rs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Rs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,p=e.z-o.z,g=t.x-o.x,y=t.y-o.y,d=t.z-o.z,m=i.x-o.x,v=i.y-o.y,T=i.z-o.z,S=Math.abs(l),C=Math.abs(c),A=Math.abs(u),_,w,U,L,I,k,W,N,V,Y,G,ae;if(S>=C&&S>=A?(U=l,k=f,V=g,ae=m,l>=0?(_=c,w=u,L=h,I=p,W=y,N=d,Y=v,G=T):(_=u,w=c,L=p,I=h,W=d,N=y,Y=T,G=v)):C>=A?(U=c,k=h,V=y,ae=v,c>=0?(_=u,w=l,L=p,I=f,W=d,N=g,Y=T,G=m):(_=l,w=u,L=f,I=p,W=g,N=d,Y=m,G=T)):(U=u,k=p,V=d,ae=T,u>=0?(_=l,w=c,L=f,I=h,W=g,N=y,Y=m,G=v):(_=c,w=l,L=h,I=f,W=y,N=g,Y=v,G=m)),U===0)return null;let q=_/U,K=w/U,ne=1/U,ue=L-q*k,he=I-K*k,Q=W-q*V,me=N-K*V,xe=Y-q*ae,Ce=G-K*ae,be=xe*me-Ce*Q,We=ue*Ce-he*xe,rt=Q*he-me*ue;if(s){if(be<0||We<0||rt<0)return null}else if((be<0||We<0||rt<0)&&(be>0||We>0||rt>0))return null;let Ve=be+We+rt;if(Ve===0)return null;let ft=ne*(be*k+We*V+rt*ae);return(Ve>0?ft<0:ft>0)?null:this.at(ft/Ve,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Yi=class extends qi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pi,this.combine=eu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Cm=new xt,Ar=new No,rc=new Ls,Rm=new B,oc=new B,ac=new B,lc=new B,_f=new B,cc=new B,Pm=new B,uc=new B,Me=class extends gn{constructor(e=new _n,t=new Yi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){cc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(_f.fromBufferAttribute(f,e),o?cc.addScaledVector(_f,u):cc.addScaledVector(_f.sub(t),u))}t.add(cc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),rc.copy(i.boundingSphere),rc.applyMatrix4(r),Ar.copy(e.ray).recast(e.near),!(rc.containsPoint(Ar.origin)===!1&&(Ar.intersectSphere(rc,Rm)===null||Ar.origin.distanceToSquared(Rm)>(e.far-e.near)**2))&&(Cm.copy(r).invert(),Ar.copy(e.ray).applyMatrix4(Cm),!(i.boundingBox!==null&&Ar.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Ar)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=h.length;g<y;g++){let d=h[g],m=o[d.materialIndex],v=Math.max(d.start,p.start),T=Math.min(a.count,Math.min(d.start+d.count,p.start+p.count));for(let S=v,C=T;S<C;S+=3){let A=a.getX(S),_=a.getX(S+1),w=a.getX(S+2);s=hc(this,m,e,i,c,u,f,A,_,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=d.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),y=Math.min(a.count,p.start+p.count);for(let d=g,m=y;d<m;d+=3){let v=a.getX(d),T=a.getX(d+1),S=a.getX(d+2);s=hc(this,o,e,i,c,u,f,v,T,S),s&&(s.faceIndex=Math.floor(d/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=h.length;g<y;g++){let d=h[g],m=o[d.materialIndex],v=Math.max(d.start,p.start),T=Math.min(l.count,Math.min(d.start+d.count,p.start+p.count));for(let S=v,C=T;S<C;S+=3){let A=S,_=S+1,w=S+2;s=hc(this,m,e,i,c,u,f,A,_,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=d.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),y=Math.min(l.count,p.start+p.count);for(let d=g,m=y;d<m;d+=3){let v=d,T=d+1,S=d+2;s=hc(this,o,e,i,c,u,f,v,T,S),s&&(s.faceIndex=Math.floor(d/3),t.push(s))}}}};function xM(n,e,t,i,s,r,o,a){let l;if(e.side===ii?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===ur,a),l===null)return null;uc.copy(a),uc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(uc);return c<t.near||c>t.far?null:{distance:c,point:uc.clone(),object:n}}function hc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,oc),n.getVertexPosition(l,ac),n.getVertexPosition(c,lc);let u=xM(n,e,t,i,oc,ac,lc,Pm);if(u){let f=new B;ir.getBarycoord(Pm,oc,ac,lc,f),s&&(u.uv=ir.getInterpolatedAttribute(s,a,l,c,f,new lt)),r&&(u.uv1=ir.getInterpolatedAttribute(r,a,l,c,f,new lt)),o&&(u.normal=ir.getInterpolatedAttribute(o,a,l,c,f,new B),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new B,materialIndex:0};ir.getNormal(oc,ac,lc,h.normal),u.face=h,u.barycoord=f}return u}var Cr=class extends li{constructor(e=null,t=1,i=1,s,r,o,a,l,c=kn,u=kn,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Da=class extends mn{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Mo=new xt,Im=new xt,fc=[],Lm=new fs,vM=new xt,Ma=new Me,ba=new Ls,Ua=class extends Me{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Da(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,vM)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new fs),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Mo),Lm.copy(e.boundingBox).applyMatrix4(Mo),this.boundingBox.union(Lm)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Ls),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Mo),ba.copy(e.boundingSphere).applyMatrix4(Mo),this.boundingSphere.union(ba)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(Ma.geometry=this.geometry,Ma.material=this.material,Ma.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ba.copy(this.boundingSphere),ba.applyMatrix4(i),e.ray.intersectsSphere(ba)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Mo),Im.multiplyMatrices(i,Mo),Ma.matrixWorld=Im,Ma.raycast(e,fc);for(let o=0,a=fc.length;o<a;o++){let l=fc[o];l.instanceId=r,l.object=this,t.push(l)}fc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Da(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Cr(new Float32Array(s*this.count),s,this.count,Go,Li));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Tr=new Ls,yM=new lt(.5,.5),dc=new B,sr=class{constructor(e=new Wi,t=new Wi,i=new Wi,s=new Wi,r=new Wi,o=new Wi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ri,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],p=r[7],g=r[8],y=r[9],d=r[10],m=r[11],v=r[12],T=r[13],S=r[14],C=r[15];if(s[0].setComponents(c-o,p-u,m-g,C-v).normalize(),s[1].setComponents(c+o,p+u,m+g,C+v).normalize(),s[2].setComponents(c+a,p+f,m+y,C+T).normalize(),s[3].setComponents(c-a,p-f,m-y,C-T).normalize(),i)s[4].setComponents(l,h,d,S).normalize(),s[5].setComponents(c-l,p-h,m-d,C-S).normalize();else if(s[4].setComponents(c-l,p-h,m-d,C-S).normalize(),t===Ri)s[5].setComponents(c+l,p+h,m+d,C+S).normalize();else if(t===Co)s[5].setComponents(l,h,d,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Tr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Tr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Tr)}intersectsSprite(e){Tr.center.set(0,0,0);let t=yM.distanceTo(e.center);return Tr.radius=.7071067811865476+t,Tr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Tr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(dc.x=s.normal.x>0?e.max.x:e.min.x,dc.y=s.normal.y>0?e.max.y:e.min.y,dc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(dc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Nm=new xt,Uc=class n{constructor(){this.coordinateSystem=Ri,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Nm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new sr),i[s].setFromProjectionMatrix(Nm,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new sr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var rr=class extends qi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new qe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Fc=new B,Oc=new B,Dm=new xt,wa=new No,pc=new Ls,xf=new B,Um=new B,yi=class extends gn{constructor(e=new _n,t=new rr){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Fc.fromBufferAttribute(t,s-1),Oc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Fc.distanceTo(Oc);e.setAttribute("lineDistance",new Dt(i,1))}else Ze("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),pc.copy(i.boundingSphere),pc.applyMatrix4(s),pc.radius+=r,e.ray.intersectsSphere(pc)===!1)return;Dm.copy(s).invert(),wa.copy(e.ray).applyMatrix4(Dm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let p=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let y=p,d=g-1;y<d;y+=c){let m=u.getX(y),v=u.getX(y+1),T=mc(this,e,wa,l,m,v,y);T&&t.push(T)}if(this.isLineLoop){let y=u.getX(g-1),d=u.getX(p),m=mc(this,e,wa,l,y,d,g-1);m&&t.push(m)}}else{let p=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=p,d=g-1;y<d;y+=c){let m=mc(this,e,wa,l,y,y+1,y);m&&t.push(m)}if(this.isLineLoop){let y=mc(this,e,wa,l,g-1,p,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function mc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Fc.fromBufferAttribute(a,s),Oc.fromBufferAttribute(a,r),t.distanceSqToSegment(Fc,Oc,xf,Um)>i)return;xf.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(xf);if(!(c<e.near||c>e.far))return{distance:c,point:Um.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Fm=new B,Om=new B,Fa=class extends yi{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)Fm.fromBufferAttribute(t,s),Om.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Fm.distanceTo(Om);e.setAttribute("lineDistance",new Dt(i,1))}else Ze("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Oa=class extends li{constructor(e=[],t=Nr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ns=class extends li{constructor(e,t,i=Zi,s,r,o,a=kn,l=kn,c,u=Is,f=1){if(u!==Is&&u!==Os)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Po(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ba=class extends Ns{constructor(e,t=Zi,i=Nr,s,r,o=kn,a=kn,l,c=Is){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ka=class extends li{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},un=class n extends _n{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,p=0;g("z","y","x",-1,-1,i,t,e,o,r,0),g("z","y","x",1,-1,i,t,-e,o,r,1),g("x","z","y",1,1,e,i,t,s,o,2),g("x","z","y",1,-1,e,i,-t,s,o,3),g("x","y","z",1,-1,e,t,i,s,r,4),g("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Dt(c,3)),this.setAttribute("normal",new Dt(u,3)),this.setAttribute("uv",new Dt(f,2));function g(y,d,m,v,T,S,C,A,_,w,U){let L=S/_,I=C/w,k=S/2,W=C/2,N=A/2,V=_+1,Y=w+1,G=0,ae=0,q=new B;for(let K=0;K<Y;K++){let ne=K*I-W;for(let ue=0;ue<V;ue++){let he=ue*L-k;q[y]=he*v,q[d]=ne*T,q[m]=N,c.push(q.x,q.y,q.z),q[y]=0,q[d]=0,q[m]=A>0?1:-1,u.push(q.x,q.y,q.z),f.push(ue/_),f.push(1-K/w),G+=1}}for(let K=0;K<w;K++)for(let ne=0;ne<_;ne++){let ue=h+ne+V*K,he=h+ne+V*(K+1),Q=h+(ne+1)+V*(K+1),me=h+(ne+1)+V*K;l.push(ue,he,me),l.push(he,Q,me),ae+=6}a.addGroup(p,ae,U),p+=ae,h+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Wt=class n extends _n{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],f=[],h=[],p=[],g=0,y=[],d=i/2,m=0;v(),o===!1&&(e>0&&T(!0),t>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new Dt(f,3)),this.setAttribute("normal",new Dt(h,3)),this.setAttribute("uv",new Dt(p,2));function v(){let S=new B,C=new B,A=0,_=(t-e)/i;for(let w=0;w<=r;w++){let U=[],L=w/r,I=L*(t-e)+e;for(let k=0;k<=s;k++){let W=k/s,N=W*l+a,V=Math.sin(N),Y=Math.cos(N);C.x=I*V,C.y=-L*i+d,C.z=I*Y,f.push(C.x,C.y,C.z),S.set(V,_,Y).normalize(),h.push(S.x,S.y,S.z),p.push(W,1-L),U.push(g++)}y.push(U)}for(let w=0;w<s;w++)for(let U=0;U<r;U++){let L=y[U][w],I=y[U+1][w],k=y[U+1][w+1],W=y[U][w+1];(e>0||U!==0)&&(u.push(L,I,W),A+=3),(t>0||U!==r-1)&&(u.push(I,k,W),A+=3)}c.addGroup(m,A,0),m+=A}function T(S){let C=g,A=new lt,_=new B,w=0,U=S===!0?e:t,L=S===!0?1:-1;for(let k=1;k<=s;k++)f.push(0,d*L,0),h.push(0,L,0),p.push(.5,.5),g++;let I=g;for(let k=0;k<=s;k++){let N=k/s*l+a,V=Math.cos(N),Y=Math.sin(N);_.x=U*Y,_.y=d*L,_.z=U*V,f.push(_.x,_.y,_.z),h.push(0,L,0),A.x=V*.5+.5,A.y=Y*.5*L+.5,p.push(A.x,A.y),g++}for(let k=0;k<s;k++){let W=C+k,N=I+k;S===!0?u.push(N,N+1,W):u.push(N+1,N,W),w+=3}c.addGroup(m,w,S===!0?1:2),m+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Ds=class n extends Wt{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Bc=class n extends _n{constructor(e=[],t=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new Dt(r,3)),this.setAttribute("normal",new Dt(r.slice(),3)),this.setAttribute("uv",new Dt(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(v){let T=new B,S=new B,C=new B;for(let A=0;A<t.length;A+=3)p(t[A+0],T),p(t[A+1],S),p(t[A+2],C),l(T,S,C,v)}function l(v,T,S,C){let A=C+1,_=[];for(let w=0;w<=A;w++){_[w]=[];let U=v.clone().lerp(S,w/A),L=T.clone().lerp(S,w/A),I=A-w;for(let k=0;k<=I;k++)k===0&&w===A?_[w][k]=U:_[w][k]=U.clone().lerp(L,k/I)}for(let w=0;w<A;w++)for(let U=0;U<2*(A-w)-1;U++){let L=Math.floor(U/2);U%2===0?(h(_[w][L+1]),h(_[w+1][L]),h(_[w][L])):(h(_[w][L+1]),h(_[w+1][L+1]),h(_[w+1][L]))}}function c(v){let T=new B;for(let S=0;S<r.length;S+=3)T.x=r[S+0],T.y=r[S+1],T.z=r[S+2],T.normalize().multiplyScalar(v),r[S+0]=T.x,r[S+1]=T.y,r[S+2]=T.z}function u(){let v=new B;for(let T=0;T<r.length;T+=3){v.x=r[T+0],v.y=r[T+1],v.z=r[T+2];let S=d(v)/2/Math.PI+.5,C=m(v)/Math.PI+.5;o.push(S,1-C)}g(),f()}function f(){for(let v=0;v<o.length;v+=6){let T=o[v+0],S=o[v+2],C=o[v+4],A=Math.max(T,S,C),_=Math.min(T,S,C);A>.9&&_<.1&&(T<.2&&(o[v+0]+=1),S<.2&&(o[v+2]+=1),C<.2&&(o[v+4]+=1))}}function h(v){r.push(v.x,v.y,v.z)}function p(v,T){let S=v*3;T.x=e[S+0],T.y=e[S+1],T.z=e[S+2]}function g(){let v=new B,T=new B,S=new B,C=new B,A=new lt,_=new lt,w=new lt;for(let U=0,L=0;U<r.length;U+=9,L+=6){v.set(r[U+0],r[U+1],r[U+2]),T.set(r[U+3],r[U+4],r[U+5]),S.set(r[U+6],r[U+7],r[U+8]),A.set(o[L+0],o[L+1]),_.set(o[L+2],o[L+3]),w.set(o[L+4],o[L+5]),C.copy(v).add(T).add(S).divideScalar(3);let I=d(C);y(A,L+0,v,I),y(_,L+2,T,I),y(w,L+4,S,I)}}function y(v,T,S,C){C<0&&v.x===1&&(o[T]=v.x-1),S.x===0&&S.z===0&&(o[T]=C/2/Math.PI+.5)}function d(v){return Math.atan2(v.z,-v.x)}function m(v){return Math.atan2(-v.y,Math.sqrt(v.x*v.x+v.z*v.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.vertices,e.indices,e.radius,e.detail)}};var or=class n extends Bc{constructor(e=1,t=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new n(e.radius,e.detail)}},Us=class n extends _n{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,h=t/l,p=[],g=[],y=[],d=[];for(let m=0;m<u;m++){let v=m*h-o;for(let T=0;T<c;T++){let S=T*f-r;g.push(S,-v,0),y.push(0,0,1),d.push(T/a),d.push(1-m/l)}}for(let m=0;m<l;m++)for(let v=0;v<a;v++){let T=v+c*m,S=v+c*(m+1),C=v+1+c*(m+1),A=v+1+c*m;p.push(T,S,A),p.push(S,C,A)}this.setIndex(p),this.setAttribute("position",new Dt(g,3)),this.setAttribute("normal",new Dt(y,3)),this.setAttribute("uv",new Dt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var ds=class n extends _n{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],f=new B,h=new B,p=[],g=[],y=[],d=[];for(let m=0;m<=i;m++){let v=[],T=m/i,S=o+T*a,C=e*Math.cos(S),A=Math.sqrt(e*e-C*C),_=0;m===0&&o===0?_=.5/t:m===i&&l===Math.PI&&(_=-.5/t);for(let w=0;w<=t;w++){let U=w/t,L=s+U*r;f.x=-A*Math.cos(L),f.y=C,f.z=A*Math.sin(L),g.push(f.x,f.y,f.z),h.copy(f).normalize(),y.push(h.x,h.y,h.z),d.push(U+_,1-T),v.push(c++)}u.push(v)}for(let m=0;m<i;m++)for(let v=0;v<t;v++){let T=u[m][v+1],S=u[m][v],C=u[m+1][v],A=u[m+1][v+1];(m!==0||o>0)&&p.push(T,S,A),(m!==i-1||l<Math.PI)&&p.push(S,C,A)}this.setIndex(p),this.setAttribute("position",new Dt(g,3)),this.setAttribute("normal",new Dt(y,3)),this.setAttribute("uv",new Dt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var $i=class n extends _n{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],f=[],h=new B,p=new B,g=new B;for(let y=0;y<=i;y++){let d=o+y/i*a;for(let m=0;m<=s;m++){let v=m/s*r;p.x=(e+t*Math.cos(d))*Math.cos(v),p.y=(e+t*Math.cos(d))*Math.sin(v),p.z=t*Math.sin(d),c.push(p.x,p.y,p.z),h.x=e*Math.cos(v),h.y=e*Math.sin(v),g.subVectors(p,h).normalize(),u.push(g.x,g.y,g.z),f.push(m/s),f.push(y/i)}}for(let y=1;y<=i;y++)for(let d=1;d<=s;d++){let m=(s+1)*y+d-1,v=(s+1)*(y-1)+d-1,T=(s+1)*(y-1)+d,S=(s+1)*y+d;l.push(m,v,S),l.push(v,T,S)}this.setIndex(l),this.setAttribute("position",new Dt(c,3)),this.setAttribute("normal",new Dt(u,3)),this.setAttribute("uv",new Dt(f,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};var za=class extends qi{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new qe(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function Ur(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(Bm(s))s.isRenderTargetTexture?(Ze("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Bm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function qn(n){let e={};for(let t=0;t<n.length;t++){let i=Ur(n[t]);for(let s in i)e[s]=i[s]}return e}function Bm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function SM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Qf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:_t.workingColorSpace}var Lg={clone:Ur,merge:qn},MM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,bM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ci=class extends qi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=MM,this.fragmentShader=bM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Ur(e.uniforms),this.uniformsGroups=SM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new qe().setHex(s.value);break;case"v2":this.uniforms[i].value=new lt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new B().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Ht().fromArray(s.value);break;case"m3":this.uniforms[i].value=new tt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new xt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},kc=class extends ci{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Ga=class extends qi{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new qe(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new qe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=il,this.normalScale=new lt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Va=class extends qi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new qe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=il,this.normalScale=new lt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pi,this.combine=eu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},zc=class extends qi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=_g,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Gc=class extends qi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function bo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function gc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var ar=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Vc=class extends ar{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Sf,endingEnd:Sf}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Mf:r=e,a=2*t-i;break;case bf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Mf:o=e,l=2*i-t;break;case bf:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,p=this._weightNext,g=(i-t)/(s-t),y=g*g,d=y*g,m=-h*d+2*h*y-h*g,v=(1+h)*d+(-1.5-2*h)*y+(-.5+h)*g+1,T=(-1-p)*d+(1.5+p)*y+.5*g,S=p*d-p*y;for(let C=0;C!==a;++C)r[C]=m*o[u+C]+v*o[c+C]+T*o[l+C]+S*o[f+C];return r}},Hc=class extends ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},Wc=class extends ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Xc=class extends ar{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let g=(i-t)/(s-t),y=1-g;for(let d=0;d!==a;++d)r[d]=o[c+d]*y+o[l+d]*g;return r}let h=a*2,p=e-1;for(let g=0;g!==a;++g){let y=o[c+g],d=o[l+g],m=p*h+g*2,v=f[m],T=f[m+1],S=e*h+g*2,C=u[S],A=u[S+1],_=EM(i,t,v,C,s);r[g]=Ng(_,y,T,A,d)}return r}};function Ng(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function wM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function EM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=Ng(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=wM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Si=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=bo(t,this.TimeBufferType),this.values=bo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:bo(e.times,Array),values:bo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),gc(e.settings)&&(i.settings={inTangents:bo(e.settings.inTangents,Array),outTangents:bo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Wc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Hc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Vc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Xc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Aa:t=this.InterpolantFactoryMethodDiscrete;break;case Pc:t=this.InterpolantFactoryMethodLinear;break;case vc:t=this.InterpolantFactoryMethodSmooth;break;case yf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ze("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Aa;case this.InterpolantFactoryMethodLinear:return Pc;case this.InterpolantFactoryMethodSmooth:return vc;case this.InterpolantFactoryMethodBezier:return yf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;gc(this.settings)&&(km(this.settings.inTangents,e),km(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;gc(this.settings)&&(zm(this.settings.inTangents,e),zm(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Qe("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Qe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Qe("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Qe("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&KS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qe("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===vc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*i,h=f-i,p=f+i;for(let g=0;g!==i;++g){let y=t[f+g];if(y!==t[h+g]||y!==t[p+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,h=o*i;for(let p=0;p!==i;++p)t[h+p]=t[f+p]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,gc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function km(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function zm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Si.prototype.ValueTypeName="";Si.prototype.TimeBufferType=Float32Array;Si.prototype.ValueBufferType=Float32Array;Si.prototype.DefaultInterpolation=Pc;var lr=class extends Si{constructor(e,t,i){super(e,t,i)}};lr.prototype.ValueTypeName="bool";lr.prototype.ValueBufferType=Array;lr.prototype.DefaultInterpolation=Aa;lr.prototype.InterpolantFactoryMethodLinear=void 0;lr.prototype.InterpolantFactoryMethodSmooth=void 0;var qc=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};qc.prototype.ValueTypeName="color";var Yc=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};Yc.prototype.ValueTypeName="number";var $c=class extends ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Et.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ha=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new $c(this.times,this.values,this.getValueSize(),e)}};Ha.prototype.ValueTypeName="quaternion";Ha.prototype.InterpolantFactoryMethodSmooth=void 0;var cr=class extends Si{constructor(e,t,i){super(e,t,i)}};cr.prototype.ValueTypeName="string";cr.prototype.ValueBufferType=Array;cr.prototype.DefaultInterpolation=Aa;cr.prototype.InterpolantFactoryMethodLinear=void 0;cr.prototype.InterpolantFactoryMethodSmooth=void 0;var Zc=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};Zc.prototype.ValueTypeName="vector";var Jc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let p=c[f],g=c[f+1];if(p.global&&(p.lastIndex=0),p.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Dg=new Jc,jc=class{constructor(e){this.manager=e!==void 0?e:Dg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};jc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Do=class extends gn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new qe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Wa=class extends Do{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(gn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new qe(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},vf=new xt,Gm=new B,Vm=new B,Kc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new lt(512,512),this.mapType=Xn,this.map=null,this.mapPass=null,this.matrix=new xt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new sr,this._frameExtents=new lt(1,1),this._viewportCount=1,this._viewports=[new Ht(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Gm.setFromMatrixPosition(e.matrixWorld),t.position.copy(Gm),Vm.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Vm),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){vf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(vf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Co||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(vf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},_c=new B,xc=new Et,us=new B,Xa=class extends gn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new xt,this.projectionMatrix=new xt,this.projectionMatrixInverse=new xt,this.coordinateSystem=Ri,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(_c,xc,us),us.x===1&&us.y===1&&us.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_c,xc,us.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(_c,xc,us),us.x===1&&us.y===1&&us.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_c,xc,us.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},nr=new B,Hm=new lt,Wm=new lt,ti=class extends Xa{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Ic*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Jh*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ic*2*Math.atan(Math.tan(Jh*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){nr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(nr.x,nr.y).multiplyScalar(-e/nr.z),nr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(nr.x,nr.y).multiplyScalar(-e/nr.z)}getViewSize(e,t){return this.getViewBounds(e,Hm,Wm),t.subVectors(Wm,Hm)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Jh*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var qa=class extends Xa{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},wf=class extends Kc{constructor(){super(new qa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Uo=class extends Do{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(gn.DEFAULT_UP),this.updateMatrix(),this.target=new gn,this.shadow=new wf}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},Ya=class extends Do{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var wo=-90,Eo=1,Fo=class extends gn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ti(wo,Eo,e,t);s.layers=this.layers,this.add(s);let r=new ti(wo,Eo,e,t);r.layers=this.layers,this.add(r);let o=new ti(wo,Eo,e,t);o.layers=this.layers,this.add(o);let a=new ti(wo,Eo,e,t);a.layers=this.layers,this.add(a);let l=new ti(wo,Eo,e,t);l.layers=this.layers,this.add(l);let c=new ti(wo,Eo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ri)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Co)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let d=!1;e.isWebGLRenderer===!0?d=e.state.buffers.depth.getReversed():d=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=y,e.setRenderTarget(i,5,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,p),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},Qc=class extends ti{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var ed="\\[\\]\\.:\\/",AM=new RegExp("["+ed+"]","g"),td="[^"+ed+"]",TM="[^"+ed.replace("\\.","")+"]",CM=/((?:WC+[\/:])*)/.source.replace("WC",td),RM=/(WCOD+)?/.source.replace("WCOD",TM),PM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",td),IM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",td),LM=new RegExp("^"+CM+RM+PM+IM+"$"),NM=["material","materials","bones","map"],Ef=class{constructor(e,t,i){let s=i||Jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Jt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(AM,"")}static parseTrackName(e){let t=LM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);NM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ze("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Qe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Qe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Qe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){Qe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){Qe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Qe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Jt.Composite=Ef;Jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Jt.prototype.GetterByBindingType=[Jt.prototype._getValue_direct,Jt.prototype._getValue_array,Jt.prototype._getValue_arrayElement,Jt.prototype._getValue_toArray];Jt.prototype.SetterByBindingTypeAndVersioning=[[Jt.prototype._setValue_direct,Jt.prototype._setValue_direct_setNeedsUpdate,Jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_array,Jt.prototype._setValue_array_setNeedsUpdate,Jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_arrayElement,Jt.prototype._setValue_arrayElement_setNeedsUpdate,Jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_fromArray,Jt.prototype._setValue_fromArray_setNeedsUpdate,Jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var zP=new Float32Array(1);var Xm=new xt,Rr=class{constructor(e,t,i=0,s=1/0){this.ray=new No(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new Io,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):Qe("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Xm.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Xm),this}intersectObject(e,t=!0,i=[]){return Af(e,this,i,t),i.sort(qm),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Af(e[s],this,i,t);return i.sort(qm),i}};function qm(n,e){return n.distance-e.distance}function Af(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Af(r[o],e,t,!0)}}var Tf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var $a=class extends Xi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function nd(n,e,t,i){let s=DM(i);switch(t){case Xf:return n*e;case Go:return n*e/s.components*s.byteLength;case au:return n*e/s.components*s.byteLength;case ji:return n*e*2/s.components*s.byteLength;case lu:return n*e*2/s.components*s.byteLength;case qf:return n*e*3/s.components*s.byteLength;case ui:return n*e*4/s.components*s.byteLength;case cu:return n*e*4/s.components*s.byteLength;case ja:case Ka:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Qa:case el:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case hu:case du:return Math.max(n,16)*Math.max(e,8)/4;case uu:case fu:return Math.max(n,8)*Math.max(e,8)/2;case pu:case mu:case _u:case xu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case gu:case tl:case vu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case yu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Su:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Mu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case bu:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case wu:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Eu:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Au:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Tu:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Cu:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Ru:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Pu:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Iu:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Lu:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Nu:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Du:case Uu:case Fu:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Ou:case Bu:return Math.ceil(n/4)*Math.ceil(e/4)*8;case nl:case ku:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function DM(n){switch(n){case Xn:case Gf:return{byteLength:1,components:1};case zo:case Vf:case Ji:return{byteLength:2,components:1};case ru:case ou:return{byteLength:2,components:4};case Zi:case su:case Li:return{byteLength:4,components:1};case Hf:case Wf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ze("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function n0(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function FM(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((p,g)=>p.start-g.start);let h=0;for(let p=1;p<f.length;p++){let g=f[h],y=f[p];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++h,f[h]=y)}f.length=h+1;for(let p=0,g=f.length;p<g;p++){let y=f[p];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var OM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,BM=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,kM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,zM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,GM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,VM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,HM=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,WM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,XM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,qM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,YM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,$M=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ZM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,JM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,jM=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,KM=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,QM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,eb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,tb=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,nb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ib=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,sb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,rb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,ob=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,ab=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,lb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,cb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ub=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,hb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,fb="gl_FragColor = linearToOutputTexel( gl_FragColor );",db=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,pb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,mb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,gb=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,_b=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,xb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,vb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,yb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Sb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Mb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,bb=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,wb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Eb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Ab=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Tb=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Cb=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Rb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Pb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Ib=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Lb=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Nb=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Db=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Ub=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Fb=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Ob=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Bb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,kb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,zb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Gb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Vb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Hb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Wb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Xb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,qb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Yb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,$b=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Zb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Jb=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,jb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Kb=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Qb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ew=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,tw=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,nw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,iw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,sw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,rw=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,ow=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,aw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,lw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,cw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,uw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,hw=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,fw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,dw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,pw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,mw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,gw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,_w=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,xw=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,vw=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,yw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Sw=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Mw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,bw=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,ww=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Ew=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Aw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Tw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Cw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Rw=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Pw=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Iw=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Lw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Nw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Dw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Uw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Fw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Ow=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Bw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,kw=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,zw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Gw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Vw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Hw=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Ww=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Xw=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,qw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Yw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$w=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Zw=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Jw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,jw=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Kw=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Qw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,e1=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,t1=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,n1=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,i1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,s1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,r1=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,o1=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,a1=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,l1=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,c1=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,u1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,h1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,f1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,d1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,p1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,m1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ht={alphahash_fragment:OM,alphahash_pars_fragment:BM,alphamap_fragment:kM,alphamap_pars_fragment:zM,alphatest_fragment:GM,alphatest_pars_fragment:VM,aomap_fragment:HM,aomap_pars_fragment:WM,batching_pars_vertex:XM,batching_vertex:qM,begin_vertex:YM,beginnormal_vertex:$M,bsdfs:ZM,iridescence_fragment:JM,bumpmap_pars_fragment:jM,clipping_planes_fragment:KM,clipping_planes_pars_fragment:QM,clipping_planes_pars_vertex:eb,clipping_planes_vertex:tb,color_fragment:nb,color_pars_fragment:ib,color_pars_vertex:sb,color_vertex:rb,common:ob,defaultnormal_vertex:ab,displacementmap_pars_vertex:lb,displacementmap_vertex:cb,emissivemap_fragment:ub,emissivemap_pars_fragment:hb,colorspace_fragment:fb,colorspace_pars_fragment:db,envmap_fragment:pb,envmap_common_pars_fragment:mb,envmap_pars_fragment:gb,envmap_pars_vertex:_b,envmap_physical_pars_fragment:Cb,envmap_vertex:xb,fog_vertex:vb,fog_pars_vertex:yb,fog_fragment:Sb,fog_pars_fragment:Mb,gradientmap_pars_fragment:bb,lightmap_pars_fragment:wb,lights_lambert_fragment:Eb,lights_lambert_pars_fragment:Ab,lights_pars_begin:Tb,lights_toon_fragment:Rb,lights_toon_pars_fragment:Pb,lights_phong_fragment:Ib,lights_phong_pars_fragment:Lb,lights_physical_fragment:Nb,lights_physical_pars_fragment:Db,lights_fragment_begin:Ub,lights_fragment_maps:Fb,lights_fragment_end:Ob,lightprobes_pars_fragment:Bb,logdepthbuf_fragment:kb,logdepthbuf_pars_fragment:zb,logdepthbuf_pars_vertex:Gb,logdepthbuf_vertex:Vb,map_fragment:Hb,map_pars_fragment:Wb,map_particle_fragment:Xb,map_particle_pars_fragment:qb,metalnessmap_fragment:Yb,metalnessmap_pars_fragment:$b,morphinstance_vertex:Zb,morphcolor_vertex:Jb,morphnormal_vertex:jb,morphtarget_pars_vertex:Kb,morphtarget_vertex:Qb,normal_fragment_begin:ew,normal_fragment_maps:tw,normal_pars_fragment:nw,normal_pars_vertex:iw,normal_vertex:sw,normalmap_pars_fragment:rw,clearcoat_normal_fragment_begin:ow,clearcoat_normal_fragment_maps:aw,clearcoat_pars_fragment:lw,iridescence_pars_fragment:cw,opaque_fragment:uw,packing:hw,premultiplied_alpha_fragment:fw,project_vertex:dw,dithering_fragment:pw,dithering_pars_fragment:mw,roughnessmap_fragment:gw,roughnessmap_pars_fragment:_w,shadowmap_pars_fragment:xw,shadowmap_pars_vertex:vw,shadowmap_vertex:yw,shadowmask_pars_fragment:Sw,skinbase_vertex:Mw,skinning_pars_vertex:bw,skinning_vertex:ww,skinnormal_vertex:Ew,specularmap_fragment:Aw,specularmap_pars_fragment:Tw,tonemapping_fragment:Cw,tonemapping_pars_fragment:Rw,transmission_fragment:Pw,transmission_pars_fragment:Iw,uv_pars_fragment:Lw,uv_pars_vertex:Nw,uv_vertex:Dw,worldpos_vertex:Uw,background_vert:Fw,background_frag:Ow,backgroundCube_vert:Bw,backgroundCube_frag:kw,cube_vert:zw,cube_frag:Gw,depth_vert:Vw,depth_frag:Hw,distance_vert:Ww,distance_frag:Xw,equirect_vert:qw,equirect_frag:Yw,linedashed_vert:$w,linedashed_frag:Zw,meshbasic_vert:Jw,meshbasic_frag:jw,meshlambert_vert:Kw,meshlambert_frag:Qw,meshmatcap_vert:e1,meshmatcap_frag:t1,meshnormal_vert:n1,meshnormal_frag:i1,meshphong_vert:s1,meshphong_frag:r1,meshphysical_vert:o1,meshphysical_frag:a1,meshtoon_vert:l1,meshtoon_frag:c1,points_vert:u1,points_frag:h1,shadow_vert:f1,shadow_frag:d1,sprite_vert:p1,sprite_frag:m1},Ne={common:{diffuse:{value:new qe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new tt},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new tt}},envmap:{envMap:{value:null},envMapRotation:{value:new tt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new tt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new tt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new tt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new tt},normalScale:{value:new lt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new tt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new tt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new tt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new tt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new qe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new qe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0},uvTransform:{value:new tt}},sprite:{diffuse:{value:new qe(16777215)},opacity:{value:1},center:{value:new lt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new tt},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0}}},gs={basic:{uniforms:qn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:qn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new qe(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:qn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new qe(0)},specular:{value:new qe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:qn([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new qe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:qn([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new qe(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:qn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:qn([Ne.points,Ne.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:qn([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:qn([Ne.common,Ne.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:qn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:qn([Ne.sprite,Ne.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new tt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new tt}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:qn([Ne.common,Ne.displacementmap,{referencePosition:{value:new B},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:qn([Ne.lights,Ne.fog,{color:{value:new qe(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};gs.physical={uniforms:qn([gs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new tt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new tt},clearcoatNormalScale:{value:new lt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new tt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new tt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new tt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new tt},sheen:{value:0},sheenColor:{value:new qe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new tt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new tt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new tt},transmissionSamplerSize:{value:new lt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new tt},attenuationDistance:{value:0},attenuationColor:{value:new qe(0)},specularColor:{value:new qe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new tt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new tt},anisotropyVector:{value:new lt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new tt}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var zu={r:0,b:0,g:0},g1=new xt,i0=new tt;i0.set(-1,0,0,0,1,0,0,0,1);function _1(n,e,t,i,s,r){let o=new qe(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function p(v){let T=v.isScene===!0?v.background:null;if(T&&T.isTexture){let S=v.backgroundBlurriness>0;T=e.get(T,S)}return T}function g(v){let T=!1,S=p(v);S===null?d(o,a):S&&S.isColor&&(d(S,1),T=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(v,T){let S=p(T);S&&S.isCubeTexture?(c===void 0&&(c=new Me(new un(1,1,1),new ci({name:"BackgroundCubeMaterial",uniforms:Ur(gs.backgroundCube.uniforms),vertexShader:gs.backgroundCube.vertexShader,fragmentShader:gs.backgroundCube.fragmentShader,side:ii,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(g1.makeRotationFromEuler(T.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(i0),c.material.toneMapped=_t.getTransfer(S.colorSpace)!==Tt,(u!==S||f!==S.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Me(new Us(2,2),new ci({name:"BackgroundMaterial",uniforms:Ur(gs.background.uniforms),vertexShader:gs.background.vertexShader,fragmentShader:gs.background.fragmentShader,side:ur,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=_t.getTransfer(S.colorSpace)!==Tt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||f!==S.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function d(v,T){v.getRGB(zu,Qf(n)),t.buffers.color.setClear(zu.r,zu.g,zu.b,T,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,T=1){o.set(v),a=T,d(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,d(o,a)},render:g,addToRenderList:y,dispose:m}}function x1(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(I,k,W,N,V){let Y=!1,G=f(I,N,W,k);r!==G&&(r=G,c(r.object)),Y=p(I,N,W,V),Y&&g(I,N,W,V),V!==null&&e.update(V,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(I,k,W,N),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function f(I,k,W,N){let V=N.wireframe===!0,Y=i[k.id];Y===void 0&&(Y={},i[k.id]=Y);let G=I.isInstancedMesh===!0?I.id:0,ae=Y[G];ae===void 0&&(ae={},Y[G]=ae);let q=ae[W.id];q===void 0&&(q={},ae[W.id]=q);let K=q[V];return K===void 0&&(K=h(l()),q[V]=K),K}function h(I){let k=[],W=[],N=[];for(let V=0;V<t;V++)k[V]=0,W[V]=0,N[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:W,attributeDivisors:N,object:I,attributes:{},index:null}}function p(I,k,W,N){let V=r.attributes,Y=k.attributes,G=0,ae=W.getAttributes();for(let q in ae)if(ae[q].location>=0){let ne=V[q],ue=Y[q];if(ue===void 0&&(q==="instanceMatrix"&&I.instanceMatrix&&(ue=I.instanceMatrix),q==="instanceColor"&&I.instanceColor&&(ue=I.instanceColor)),ne===void 0||ne.attribute!==ue||ue&&ne.data!==ue.data)return!0;G++}return r.attributesNum!==G||r.index!==N}function g(I,k,W,N){let V={},Y=k.attributes,G=0,ae=W.getAttributes();for(let q in ae)if(ae[q].location>=0){let ne=Y[q];ne===void 0&&(q==="instanceMatrix"&&I.instanceMatrix&&(ne=I.instanceMatrix),q==="instanceColor"&&I.instanceColor&&(ne=I.instanceColor));let ue={};ue.attribute=ne,ne&&ne.data&&(ue.data=ne.data),V[q]=ue,G++}r.attributes=V,r.attributesNum=G,r.index=N}function y(){let I=r.newAttributes;for(let k=0,W=I.length;k<W;k++)I[k]=0}function d(I){m(I,0)}function m(I,k){let W=r.newAttributes,N=r.enabledAttributes,V=r.attributeDivisors;W[I]=1,N[I]===0&&(n.enableVertexAttribArray(I),N[I]=1),V[I]!==k&&(n.vertexAttribDivisor(I,k),V[I]=k)}function v(){let I=r.newAttributes,k=r.enabledAttributes;for(let W=0,N=k.length;W<N;W++)k[W]!==I[W]&&(n.disableVertexAttribArray(W),k[W]=0)}function T(I,k,W,N,V,Y,G){G===!0?n.vertexAttribIPointer(I,k,W,V,Y):n.vertexAttribPointer(I,k,W,N,V,Y)}function S(I,k,W,N){y();let V=N.attributes,Y=W.getAttributes(),G=k.defaultAttributeValues;for(let ae in Y){let q=Y[ae];if(q.location>=0){let K=V[ae];if(K===void 0&&(ae==="instanceMatrix"&&I.instanceMatrix&&(K=I.instanceMatrix),ae==="instanceColor"&&I.instanceColor&&(K=I.instanceColor)),K!==void 0){let ne=K.normalized,ue=K.itemSize,he=e.get(K);if(he===void 0)continue;let Q=he.buffer,me=he.type,xe=he.bytesPerElement,Ce=me===n.INT||me===n.UNSIGNED_INT||K.gpuType===su;if(K.isInterleavedBufferAttribute){let be=K.data,We=be.isInterleavedBuffer===!0?be.stride:be.itemSize,rt=K.offset;if(be.isInstancedInterleavedBuffer||be.isInstancedBufferAttribute){for(let Ve=0;Ve<q.locationSize;Ve++)m(q.location+Ve,be.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=be.meshPerAttribute*be.count)}else for(let Ve=0;Ve<q.locationSize;Ve++)d(q.location+Ve);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let Ve=0;Ve<q.locationSize;Ve++)T(q.location+Ve,ue/q.locationSize,me,ne,We*xe,(rt+ue/q.locationSize*Ve)*xe,Ce)}else{if(K.isInstancedBufferAttribute){for(let be=0;be<q.locationSize;be++)m(q.location+be,K.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let be=0;be<q.locationSize;be++)d(q.location+be);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let be=0;be<q.locationSize;be++)T(q.location+be,ue/q.locationSize,me,ne,ue*xe,ue/q.locationSize*be*xe,Ce)}}else if(G!==void 0){let ne=G[ae];if(ne!==void 0)switch(ne.length){case 2:n.vertexAttrib2fv(q.location,ne);break;case 3:n.vertexAttrib3fv(q.location,ne);break;case 4:n.vertexAttrib4fv(q.location,ne);break;default:n.vertexAttrib1fv(q.location,ne)}}}}v()}function C(){U();for(let I in i){let k=i[I];for(let W in k){let N=k[W];for(let V in N){let Y=N[V];for(let G in Y)u(Y[G].object),delete Y[G];delete N[V]}}delete i[I]}}function A(I){if(i[I.id]===void 0)return;let k=i[I.id];for(let W in k){let N=k[W];for(let V in N){let Y=N[V];for(let G in Y)u(Y[G].object),delete Y[G];delete N[V]}}delete i[I.id]}function _(I){for(let k in i){let W=i[k];for(let N in W){let V=W[N];if(V[I.id]===void 0)continue;let Y=V[I.id];for(let G in Y)u(Y[G].object),delete Y[G];delete V[I.id]}}}function w(I){for(let k in i){let W=i[k],N=I.isInstancedMesh===!0?I.id:0,V=W[N];if(V!==void 0){for(let Y in V){let G=V[Y];for(let ae in G)u(G[ae].object),delete G[ae];delete V[Y]}delete W[N],Object.keys(W).length===0&&delete i[k]}}}function U(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:L,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:w,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:d,disableUnusedAttributes:v}}function v1(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let p=0;p<u;p++)h+=c[p];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function y1(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==ui&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let w=_===Ji&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==Xn&&_!==Li&&!w&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ze("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Ze("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Ze("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),d=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:p,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:d,maxAttributes:m,maxVertexUniforms:v,maxVaryings:T,maxFragmentUniforms:S,maxSamples:C,samples:A}}function S1(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Wi,a=new tt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let p=f.length!==0||h||i!==0||s;return s=h,i=f.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,p){let g=f.clippingPlanes,y=f.clipIntersection,d=f.clipShadows,m=n.get(f);if(!s||g===null||g.length===0||r&&!d)r?u(null):c();else{let v=r?0:i,T=v*4,S=m.clippingState||null;l.value=S,S=u(g,h,T,p);for(let C=0;C!==T;++C)S[C]=t[C];m.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,p,g){let y=f!==null?f.length:0,d=null;if(y!==0){if(d=l.value,g!==!0||d===null){let m=p+y*4,v=h.matrixWorldInverse;a.getNormalMatrix(v),(d===null||d.length<m)&&(d=new Float32Array(m));for(let T=0,S=p;T!==y;++T,S+=4)o.copy(f[T]).applyMatrix4(v,a),o.normal.toArray(d,S),d[S+3]=o.constant}l.value=d,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,d}}var al=class extends vi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Oa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new un(5,5,5),r=new ci({name:"CubemapFromEquirect",uniforms:Ur(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ii,blending:Ir});r.uniforms.tEquirect.value=t;let o=new Me(s,r),a=t.minFilter;return t.minFilter===Fs&&(t.minFilter=ni),new Fo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},Ug=256,M1=3,b1=20,s0=256,r0=16,w1=3,E1=new B,A1=new qe,Vu=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Fo(1,10,null),this._boxMesh=new Me(new un(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=E1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,p=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(A1));let d=new Fo(i,s,u);return d.position.copy(a),d.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=p,l.autoClearStencil=g,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Bg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Og(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Ug,Pg(e))}_fromTexture(e,t){e.mapping===Nr||e.mapping===ko?this._setSize(e.image.length===0?Ug:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Fg(e,!1,!1),i=Math.log2(e)-M1;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Fg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Nr||e.mapping===ko?(this._cubemapMaterial===null&&(this._cubemapMaterial=Bg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Og()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=T1(),this._integrationMaterial=C1());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/r0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-w1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(s0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=R1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Fg(n,e,t){return new al(n,{minFilter:Fs,generateMipmaps:e,type:Ji,colorSpace:Ta,depthBuffer:t})}function ll(n,e,t){return new ci({name:n,uniforms:e,vertexShader:ht.cube_vert,fragmentShader:t,side:ii,blending:Ir,depthTest:!1,depthWrite:!1})}function T1(){return ll("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${s0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function C1(){return ll("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:r0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function R1(){return ll("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${b1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Og(){return ll("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Bg(){return ll("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function P1(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,p=!1){return h==null?null:p?o(h):r(h)}function r(h){if(h&&h.isTexture){let p=h.mapping;if(p===tu||p===nu)if(e.has(h)){let g=e.get(h).texture;return a(g,h.mapping)}else{let g=h.image;if(g&&g.height>0){let y=new al(g.height);return y.fromEquirectangularTexture(n,h),e.set(h,y),h.addEventListener("dispose",c),a(y.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let p=h.mapping,g=p===tu||p===nu,y=p===Nr||p===ko;if(g||y){let d=t.get(h),m=d!==void 0?d.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return i===null&&(i=new Vu(n)),d=g?i.fromEquirectangular(h,d):i.fromCubemap(h,d),d.texture.pmremVersion=h.pmremVersion,t.set(h,d),d.texture;if(d!==void 0)return d.texture;{let v=h.image;return g&&v&&v.height>0||y&&v&&l(v)?(i===null&&(i=new Vu(n)),d=g?i.fromEquirectangular(h):i.fromCubemap(h),d.texture.pmremVersion=h.pmremVersion,t.set(h,d),h.addEventListener("dispose",u),d.texture):null}}}return h}function a(h,p){return p===tu?h.mapping=Nr:p===nu&&(h.mapping=ko),h}function l(h){let p=0,g=6;for(let y=0;y<g;y++)h[y]!==void 0&&p++;return p===g}function c(h){let p=h.target;p.removeEventListener("dispose",c);let g=e.get(p);g!==void 0&&(e.delete(p),g.dispose())}function u(h){let p=h.target;p.removeEventListener("dispose",u);let g=t.get(p);g!==void 0&&(t.delete(p),g.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function I1(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Ea("WebGLRenderer: "+i+" extension not supported."),s}}}function L1(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let d in g.attributes)e.remove(g.attributes[d]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function u(g){let y=g.attributes;for(let d in y)e.update(y[d],n.ARRAY_BUFFER)}function f(g){let y=g.index,d=g.attributes.position,m=0;if(d===void 0)return;let v=y!==null?y.array.length:d.array.length/3-1,T=d.count>=65535?Na:La,S=new T(Math.ceil(v/3)*6,1),C=S.array;if(y!==null){let _=y.array;m=y.version;for(let w=0,U=0;w<v;w+=3){let L=_[w+0],I=_[w+1],k=_[w+2];C[U++]=L,C[U++]=I,C[U++]=I,C[U++]=k,C[U++]=k,C[U++]=L}}else{m=d.version;for(let _=0,w=0;_<v;_+=3){let U=_+0,L=_+1,I=_+2;C[w++]=U,C[w++]=L,C[w++]=L,C[w++]=I,C[w++]=I,C[w++]=U}}S.version=m;let A=r.get(g);A&&e.remove(A),r.set(g,S)}function h(g){let y=r.get(g);if(y){let d=g.index;d!==null&&y.version<d.version&&f(g)}else f(g);return r.get(g)}function p(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:h,dispose:p}}function N1(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),t.update(h,i,1)}function c(f,h,p){p!==0&&(n.drawElementsInstanced(i,h,r,f*o,p),t.update(h,i,p))}function u(f,h,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,p);let y=0;for(let d=0;d<p;d++)y+=h[d];t.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function D1(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:Qe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function U1(n,e,t){let i=new WeakMap,s=new Ht;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let U=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",U)};h!==void 0&&h.texture.dispose();let p=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,d=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],T=0;p===!0&&(T=1),g===!0&&(T=2),y===!0&&(T=3);let S=a.attributes.position.count*T,C=1;S>e.maxTextureSize&&(C=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let A=new Float32Array(S*C*4*f),_=new Pa(A,S,C,f);_.type=Li,_.needsUpdate=!0;let w=T*4;for(let L=0;L<f;L++){let I=d[L],k=m[L],W=v[L],N=S*C*4*L;for(let V=0;V<I.count;V++){let Y=V*w;p===!0&&(s.fromBufferAttribute(I,V),A[N+Y+0]=s.x,A[N+Y+1]=s.y,A[N+Y+2]=s.z,A[N+Y+3]=0),g===!0&&(s.fromBufferAttribute(k,V),A[N+Y+4]=s.x,A[N+Y+5]=s.y,A[N+Y+6]=s.z,A[N+Y+7]=0),y===!0&&(s.fromBufferAttribute(W,V),A[N+Y+8]=s.x,A[N+Y+9]=s.y,A[N+Y+10]=s.z,A[N+Y+11]=W.itemSize===4?s.w:1)}}h={count:f,texture:_,size:new lt(S,C)},i.set(a,h),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let y=0;y<c.length;y++)p+=c[y];let g=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function F1(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==u&&(p.update(),r.set(p,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var O1={[Df]:"LINEAR_TONE_MAPPING",[Uf]:"REINHARD_TONE_MAPPING",[Ff]:"CINEON_TONE_MAPPING",[Of]:"ACES_FILMIC_TONE_MAPPING",[kf]:"AGX_TONE_MAPPING",[Za]:"NEUTRAL_TONE_MAPPING",[Bf]:"CUSTOM_TONE_MAPPING"};function B1(n,e,t,i,s,r){let o=new vi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new _n;u.setAttribute("position",new Dt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Dt([0,2,0,0,2,0],2));let f=new kc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new Me(u,f),p=new qa(-1,1,1,-1,0,1),g=null,y=null,d=!1,m,v=null,T=[],S=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let _=0;_<T.length;_++){let w=T[_];w.setSize&&w.setSize(C,A)}},this.setEffects=function(C){T=C,S=T.length>0&&T[0].isRenderPass===!0;let A=o.width,_=o.height;T.length>0&&a===null&&(a=new vi(A,_,{type:Ji,depthBuffer:!1,stencilBuffer:!1}),l=new vi(A,_,{type:Ji,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&T.some(U=>U.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Ns(A,_),r===!0&&(c.format=Os,c.type=Dr)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let U=0;U<T.length;U++){let L=T[U];L.setSize&&L.setSize(A,_),w&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(C,A){if(d||C.toneMapping===ps&&T.length===0)return!1;if(v=A,A!==null){let _=A.width,w=A.height;(o.width!==_||o.height!==w)&&this.setSize(_,w)}return S===!1&&C.setRenderTarget(o),m=C.toneMapping,C.toneMapping=ps,!0},this.hasRenderPass=function(){return S},this.end=function(C,A){C.toneMapping=m,d=!0;let _=o,w=a;for(let U=0;U<T.length;U++){let L=T[U];L.enabled!==!1&&(L.render(C,w,_,A),L.needsSwap!==!1&&(_=w,w=w===a?l:a))}if(g!==C.outputColorSpace||y!==C.toneMapping){g=C.outputColorSpace,y=C.toneMapping,f.defines={},_t.getTransfer(g)===Tt&&(f.defines.SRGB_TRANSFER="");let U=O1[y];U&&(f.defines[U]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(v),C.render(h,p),v=null,d=!1},this.isCompositing=function(){return d},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var o0=new li,a0=new Ns(1,1),l0=new Ba(1),c0=new Pa,u0=new Dc,h0=new Oa,kg=[],zg=[],Gg=new Float32Array(16),Vg=new Float32Array(9),Hg=new Float32Array(4);function Ho(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=kg[s];if(r===void 0&&(r=new Float32Array(s),kg[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Rn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Pn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Wu(n,e){let t=zg[e];t===void 0&&(t=new Int32Array(e),zg[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function k1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function z1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rn(t,e))return;n.uniform2fv(this.addr,e),Pn(t,e)}}function G1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Rn(t,e))return;n.uniform3fv(this.addr,e),Pn(t,e)}}function V1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rn(t,e))return;n.uniform4fv(this.addr,e),Pn(t,e)}}function H1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Rn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Pn(t,e)}else{if(Rn(t,i))return;Hg.set(i),n.uniformMatrix2fv(this.addr,!1,Hg),Pn(t,i)}}function W1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Rn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Pn(t,e)}else{if(Rn(t,i))return;Vg.set(i),n.uniformMatrix3fv(this.addr,!1,Vg),Pn(t,i)}}function X1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Rn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Pn(t,e)}else{if(Rn(t,i))return;Gg.set(i),n.uniformMatrix4fv(this.addr,!1,Gg),Pn(t,i)}}function q1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function Y1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rn(t,e))return;n.uniform2iv(this.addr,e),Pn(t,e)}}function $1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Rn(t,e))return;n.uniform3iv(this.addr,e),Pn(t,e)}}function Z1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rn(t,e))return;n.uniform4iv(this.addr,e),Pn(t,e)}}function J1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function j1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rn(t,e))return;n.uniform2uiv(this.addr,e),Pn(t,e)}}function K1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Rn(t,e))return;n.uniform3uiv(this.addr,e),Pn(t,e)}}function Q1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rn(t,e))return;n.uniform4uiv(this.addr,e),Pn(t,e)}}function Xu(n){return n.version===0&&(n.compareFunction=Zf,n.needsUpdate=!0),n}function eE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Xu(a0):r=o0,t.setTexture2D(e||r,s)}function tE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||u0,s)}function nE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Xu(l0):r=h0,t.setTextureCube(e||r,s)}function iE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||c0,s)}function sE(n){switch(n){case 5126:return k1;case 35664:return z1;case 35665:return G1;case 35666:return V1;case 35674:return H1;case 35675:return W1;case 35676:return X1;case 5124:case 35670:return q1;case 35667:case 35671:return Y1;case 35668:case 35672:return $1;case 35669:case 35673:return Z1;case 5125:return J1;case 36294:return j1;case 36295:return K1;case 36296:return Q1;case 35678:case 36198:case 36298:case 36306:case 35682:return eE;case 35679:case 36299:case 36307:return tE;case 35680:case 36300:case 36308:case 36293:return nE;case 36289:case 36303:case 36311:case 36292:return iE}}function rE(n,e){n.uniform1fv(this.addr,e)}function oE(n,e){let t=Ho(e,this.size,2);n.uniform2fv(this.addr,t)}function aE(n,e){let t=Ho(e,this.size,3);n.uniform3fv(this.addr,t)}function lE(n,e){let t=Ho(e,this.size,4);n.uniform4fv(this.addr,t)}function cE(n,e){let t=Ho(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function uE(n,e){let t=Ho(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function hE(n,e){let t=Ho(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function fE(n,e){n.uniform1iv(this.addr,e)}function dE(n,e){n.uniform2iv(this.addr,e)}function pE(n,e){n.uniform3iv(this.addr,e)}function mE(n,e){n.uniform4iv(this.addr,e)}function gE(n,e){n.uniform1uiv(this.addr,e)}function _E(n,e){n.uniform2uiv(this.addr,e)}function xE(n,e){n.uniform3uiv(this.addr,e)}function vE(n,e){n.uniform4uiv(this.addr,e)}function yE(n,e,t){let i=this.cache,s=e.length,r=Wu(t,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Pn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Xu(a0):o=o0;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function SE(n,e,t){let i=this.cache,s=e.length,r=Wu(t,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Pn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||u0,r[o])}function ME(n,e,t){let i=this.cache,s=e.length,r=Wu(t,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Pn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Xu(l0):o=h0;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function bE(n,e,t){let i=this.cache,s=e.length,r=Wu(t,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Pn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||c0,r[o])}function wE(n){switch(n){case 5126:return rE;case 35664:return oE;case 35665:return aE;case 35666:return lE;case 35674:return cE;case 35675:return uE;case 35676:return hE;case 5124:case 35670:return fE;case 35667:case 35671:return dE;case 35668:case 35672:return pE;case 35669:case 35673:return mE;case 5125:return gE;case 36294:return _E;case 36295:return xE;case 36296:return vE;case 35678:case 36198:case 36298:case 36306:case 35682:return yE;case 35679:case 36299:case 36307:return SE;case 35680:case 36300:case 36308:case 36293:return ME;case 36289:case 36303:case 36311:case 36292:return bE}}var rd=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=sE(t.type)}},od=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=wE(t.type)}},ad=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},id=/(\w+)(\])?(\[|\.)?/g;function Wg(n,e){n.seq.push(e),n.map[e.id]=e}function EE(n,e,t){let i=n.name,s=i.length;for(id.lastIndex=0;;){let r=id.exec(i),o=id.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Wg(t,c===void 0?new rd(a,n,e):new od(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new ad(a),Wg(t,f)),t=f}}}var Vo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);EE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Xg(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var AE=37297,TE=0;function CE(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var qg=new tt;function RE(n){_t._getMatrix(qg,_t.workingColorSpace,n);let e=`mat3( ${qg.elements.map(t=>t.toFixed(4))} )`;switch(_t.getTransfer(n)){case Ca:return[e,"LinearTransferOETF"];case Tt:return[e,"sRGBTransferOETF"];default:return Ze("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Yg(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+CE(n.getShaderSource(e),a)}else return r}function PE(n,e){let t=RE(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var IE={[Df]:"Linear",[Uf]:"Reinhard",[Ff]:"Cineon",[Of]:"ACESFilmic",[kf]:"AgX",[Za]:"Neutral",[Bf]:"Custom"};function LE(n,e){let t=IE[e];return t===void 0?(Ze("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Gu=new B;function NE(){_t.getLuminanceCoefficients(Gu);let n=Gu.x.toFixed(4),e=Gu.y.toFixed(4),t=Gu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function DE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ol).join(`
`)}function UE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function FE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function ol(n){return n!==""}function $g(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Zg(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var OE=/^[ \t]*#include +<([\w\d./]+)>/gm;function ld(n){return n.replace(OE,BE)}function BE(n,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return ld(t)}var kE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Jg(n){return n.replace(kE,zE)}function zE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function jg(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var GE={[Pr]:"SHADOWMAP_TYPE_PCF",[Oo]:"SHADOWMAP_TYPE_VSM"};function VE(n){return GE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var HE={[ko]:"ENVMAP_MODE_REFRACTION"};function WE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":HE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var XE={[eu]:"ENVMAP_BLENDING_MULTIPLY",[pg]:"ENVMAP_BLENDING_MIX",[mg]:"ENVMAP_BLENDING_ADD"};function qE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":XE[n.combine]||"ENVMAP_BLENDING_NONE"}function YE(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=VE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=WE(t),f=qE(t),h=DE(t),p=UE(r),g=s.createProgram(),y,d,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(ol).join(`
`),y.length>0&&(y+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(ol).join(`
`),d.length>0&&(d+=`
`)):(y=[jg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ol).join(`
`),d=[jg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ps?"#define TONE_MAPPING":"",t.toneMapping!==ps?ht.tonemapping_pars_fragment:"",t.toneMapping!==ps?LE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,PE("linearToOutputTexel",t.outputColorSpace),NE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ol).join(`
`)),o=ld(o),o=$g(o,t),o=Zg(o,t),a=ld(a),a=$g(a,t),a=Zg(a,t),o=Jg(o),a=Jg(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,d=["#define varying in",t.glslVersion===Jf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Jf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let v=m+y+o,T=m+d+a,S=Xg(s,s.VERTEX_SHADER,v),C=Xg(s,s.FRAGMENT_SHADER,T);s.attachShader(g,S),s.attachShader(g,C),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function A(L){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(g)||"",k=s.getShaderInfoLog(S)||"",W=s.getShaderInfoLog(C)||"",N=I.trim(),V=k.trim(),Y=W.trim(),G=!0,ae=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,S,C);else{let q=Yg(s,S,"vertex"),K=Yg(s,C,"fragment");Qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+N+`
`+q+`
`+K)}else N!==""?Ze("WebGLProgram: Program Info Log:",N):(V===""||Y==="")&&(ae=!1);ae&&(L.diagnostics={runnable:G,programLog:N,vertexShader:{log:V,prefix:y},fragmentShader:{log:Y,prefix:d}})}s.deleteShader(S),s.deleteShader(C),_=new Vo(s,g),w=FE(s,g)}let _;this.getUniforms=function(){return _===void 0&&A(this),_};let w;this.getAttributes=function(){return w===void 0&&A(this),w};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(g,AE)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=TE++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=C,this}var $E=0,cd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new ud(e),t.set(e,i)),i}},ud=class{constructor(e){this.id=$E++,this.code=e,this.usedTimes=0}};function ZE(n){return n===ji||n===tl||n===nl}function JE(n,e,t,i,s,r){let o=new Io,a=new cd,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,w,U,L,I,k){let W=L.fog,N=I.geometry,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?L.environment:null,Y=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,G=e.get(_.envMap||V,Y),ae=h[_.type],q=i.precision;_.precision!==null&&(q=i.getMaxPrecision(_.precision),q!==_.precision&&Ze("WebGLProgram.getParameters:",_.precision,"not supported, using",q,"instead."));let K=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ne=K!==void 0?K.length:0,ue=0;N.morphAttributes.position!==void 0&&(ue=1),N.morphAttributes.normal!==void 0&&(ue=2),N.morphAttributes.color!==void 0&&(ue=3);let he,Q,me,xe;if(ae){let Re=gs[ae];he=Re.vertexShader,Q=Re.fragmentShader}else{he=_.vertexShader,Q=_.fragmentShader;let Re=a.getVertexShaderStage(_),at=a.getFragmentShaderStage(_);a.update(_,Re,at),me=Re.id,xe=at.id}let Ce=n.getRenderTarget(),be=n.state.buffers.depth.getReversed(),We=I.isInstancedMesh===!0,rt=I.isBatchedMesh===!0,Ve=!!_.map,ft=!!_.matcap,ct=!!G,it=ct&&G.isPMREMTexture===!0,Kt=!!_.aoMap,Vt=!!_.lightMap,xn=!!_.bumpMap&&_.wireframe===!1,Ut=!!_.normalMap,Nn=!!_.displacementMap,St=!!_.emissiveMap,Tn=!!_.metalnessMap,sn=!!_.roughnessMap,vn=_.anisotropy>0,O=_.clearcoat>0,Pe=_.diffuseRoughness>0,$e=_.dispersion>0,ot=_.retroreflectivity>0,we=_.iridescence>0,Ot=_.sheen>0,Ge=_.transmission>0,Ye=vn&&!!_.anisotropyMap,R=O&&!!_.clearcoatMap,M=O&&!!_.clearcoatNormalMap,X=O&&!!_.clearcoatRoughnessMap,ce=Pe&&!!_.diffuseRoughnessMap,re=we&&!!_.iridescenceMap,_e=we&&!!_.iridescenceThicknessMap,ve=Ot&&!!_.sheenColorMap,ee=Ot&&!!_.sheenRoughnessMap,ie=!!_.specularMap,pe=!!_.specularColorMap,F=!!_.specularIntensityMap,se=Ge&&!!_.transmissionMap,te=Ge&&!!_.thicknessMap,Ee=!!_.gradientMap,ge=!!_.alphaMap,Se=_.alphaTest>0,He=!!_.alphaHash,je=!!_.extensions,le=ps;_.toneMapped&&(Ce===null||Ce.isXRRenderTarget===!0)&&(le=n.toneMapping);let Be=it?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Ke={shaderID:ae,shaderType:_.type,shaderName:_.name,vertexShader:he,fragmentShader:Q,defines:_.defines,customVertexShaderID:me,customFragmentShaderID:xe,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:q,batching:rt,batchingColor:rt&&I._colorsTexture!==null,instancing:We,instancingColor:We&&I.instanceColor!==null,instancingMorph:We&&I.morphTexture!==null,outputColorSpace:Ce===null?n.outputColorSpace:Ce.isXRRenderTarget===!0?Ce.texture.colorSpace:_t.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Ve,matcap:ft,envMap:ct,envMapMode:ct&&G.mapping,envMapPMREM:it,envMapMaxLod:it?Be.length-1:null,envMapSize:it?Be[0].width:null,aoMap:Kt,lightMap:Vt,bumpMap:xn,normalMap:Ut,displacementMap:Nn,emissiveMap:St,normalMapObjectSpace:Ut&&_.normalMapType===xg,normalMapTangentSpace:Ut&&_.normalMapType===il,packedNormalMap:Ut&&_.normalMapType===il&&ZE(_.normalMap.format),metalnessMap:Tn,roughnessMap:sn,anisotropy:vn,anisotropyMap:Ye,clearcoat:O,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:X,diffuseRoughness:Pe,diffuseRoughnessMap:ce,dispersion:$e,retroreflection:ot,iridescence:we,iridescenceMap:re,iridescenceThicknessMap:_e,sheen:Ot,sheenColorMap:ve,sheenRoughnessMap:ee,specularMap:ie,specularColorMap:pe,specularIntensityMap:F,transmission:Ge,transmissionMap:se,thicknessMap:te,gradientMap:Ee,opaque:_.transparent===!1&&_.blending===Bo&&_.alphaToCoverage===!1,alphaMap:ge,alphaTest:Se,alphaHash:He,combine:_.combine,mapUv:Ve&&p(_.map.channel),aoMapUv:Kt&&p(_.aoMap.channel),lightMapUv:Vt&&p(_.lightMap.channel),bumpMapUv:xn&&p(_.bumpMap.channel),normalMapUv:Ut&&p(_.normalMap.channel),displacementMapUv:Nn&&p(_.displacementMap.channel),emissiveMapUv:St&&p(_.emissiveMap.channel),metalnessMapUv:Tn&&p(_.metalnessMap.channel),roughnessMapUv:sn&&p(_.roughnessMap.channel),anisotropyMapUv:Ye&&p(_.anisotropyMap.channel),clearcoatMapUv:R&&p(_.clearcoatMap.channel),clearcoatNormalMapUv:M&&p(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&p(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ce&&p(_.diffuseRoughnessMap.channel),iridescenceMapUv:re&&p(_.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&p(_.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&p(_.sheenColorMap.channel),sheenRoughnessMapUv:ee&&p(_.sheenRoughnessMap.channel),specularMapUv:ie&&p(_.specularMap.channel),specularColorMapUv:pe&&p(_.specularColorMap.channel),specularIntensityMapUv:F&&p(_.specularIntensityMap.channel),transmissionMapUv:se&&p(_.transmissionMap.channel),thicknessMapUv:te&&p(_.thicknessMap.channel),alphaMapUv:ge&&p(_.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Ut||vn),vertexNormals:!!N.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!N.attributes.uv&&(Ve||ge),fog:!!W,useFog:_.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||N.attributes.normal===void 0&&Ut===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:be,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:ue,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:k.filter(Re=>Re.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:le,decodeVideoTexture:Ve&&_.map.isVideoTexture===!0&&_t.getTransfer(_.map.colorSpace)===Tt,decodeVideoTextureEmissive:St&&_.emissiveMap.isVideoTexture===!0&&_t.getTransfer(_.emissiveMap.colorSpace)===Tt,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Ii,flipSided:_.side===ii,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:je&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(je&&_.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Ke.vertexUv1s=l.has(1),Ke.vertexUv2s=l.has(2),Ke.vertexUv3s=l.has(3),l.clear(),Ke}function y(_){let w=[];if(_.shaderID?w.push(_.shaderID):(w.push(_.customVertexShaderID),w.push(_.customFragmentShaderID)),_.defines!==void 0)for(let U in _.defines)w.push(U),w.push(_.defines[U]);return _.isRawShaderMaterial===!1&&(d(w,_),m(w,_),w.push(n.outputColorSpace)),w.push(_.customProgramCacheKey),w.join()}function d(_,w){_.push(w.precision),_.push(w.outputColorSpace),_.push(w.envMapMode),_.push(w.envMapPMREM),_.push(w.envMapMaxLod),_.push(w.envMapSize),_.push(w.mapUv),_.push(w.alphaMapUv),_.push(w.lightMapUv),_.push(w.aoMapUv),_.push(w.bumpMapUv),_.push(w.normalMapUv),_.push(w.displacementMapUv),_.push(w.emissiveMapUv),_.push(w.metalnessMapUv),_.push(w.roughnessMapUv),_.push(w.anisotropyMapUv),_.push(w.clearcoatMapUv),_.push(w.clearcoatNormalMapUv),_.push(w.clearcoatRoughnessMapUv),_.push(w.diffuseRoughnessMapUv),_.push(w.iridescenceMapUv),_.push(w.iridescenceThicknessMapUv),_.push(w.sheenColorMapUv),_.push(w.sheenRoughnessMapUv),_.push(w.specularMapUv),_.push(w.specularColorMapUv),_.push(w.specularIntensityMapUv),_.push(w.transmissionMapUv),_.push(w.thicknessMapUv),_.push(w.combine),_.push(w.fogExp2),_.push(w.sizeAttenuation),_.push(w.morphTargetsCount),_.push(w.numSunLights),_.push(w.numDirLights),_.push(w.numPointLights),_.push(w.numSpotLights),_.push(w.numSpotLightMaps),_.push(w.numHemiLights),_.push(w.numRectAreaLights),_.push(w.numSunLightShadows),_.push(w.numDirLightShadows),_.push(w.numPointLightShadows),_.push(w.numSpotLightShadows),_.push(w.numSpotLightShadowsWithMaps),_.push(w.numLightProbes),_.push(w.numLightProbeGrids),_.push(w.shadowMapType),_.push(w.toneMapping),_.push(w.numClippingPlanes),_.push(w.numClipIntersection),_.push(w.depthPacking)}function m(_,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let w=h[_.type],U;if(w){let L=gs[w];U=Lg.clone(L.uniforms)}else U=_.uniforms;return U}function T(_,w){let U=u.get(w);return U!==void 0?++U.usedTimes:(U=new YE(n,w,_,s),c.push(U),u.set(w,U)),U}function S(_){if(--_.usedTimes===0){let w=c.indexOf(_);c[w]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function A(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:v,acquireProgram:T,releaseProgram:S,releaseShaderCache:C,programs:c,dispose:A}}function jE(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function KE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Kg(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Qg(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let p=0;return h.isInstancedMesh&&(p+=2),h.isSkinnedMesh&&(p+=1),p}function a(h,p,g,y,d,m){let v=n[e];return v===void 0?(v={id:h.id,object:h,geometry:p,material:g,materialVariant:o(h),groupOrder:y,renderOrder:h.renderOrder,z:d,group:m},n[e]=v):(v.id=h.id,v.object=h,v.geometry=p,v.material=g,v.materialVariant=o(h),v.groupOrder=y,v.renderOrder=h.renderOrder,v.z=d,v.group=m),e++,v}function l(h,p,g,y,d,m,v){v.reversedDepth===!0&&(d=-d);let T=a(h,p,g,y,d,m);g.transmission>0?i.push(T):g.transparent===!0?s.push(T):t.push(T)}function c(h,p,g,y,d,m){let v=a(h,p,g,y,d,m);g.transmission>0?i.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function u(h,p){t.length>1&&t.sort(h||KE),i.length>1&&i.sort(p||Kg),s.length>1&&s.sort(p||Kg)}function f(){for(let h=e,p=n.length;h<p;h++){let g=n[h];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function QE(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Qg,n.set(i,[o])):s>=r.length?(o=new Qg,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function eA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new B,color:new qe};break;case"SpotLight":t={position:new B,direction:new B,color:new qe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new B,color:new qe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new B,skyColor:new qe,groundColor:new qe};break;case"RectAreaLight":t={color:new qe,position:new B,halfWidth:new B,halfHeight:new B};break}return n[e.id]=t,t}}}function tA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new lt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new lt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new lt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var nA=0;function iA(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function sA(n){let e=new eA,t=tA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new B);let s=new B,r=new xt,o=new xt;function a(c){let u=0,f=0,h=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let p=0,g=0,y=0,d=0,m=0,v=0,T=0,S=0,C=0,A=0,_=0,w=0,U=0,L=0;c.sort(iA);for(let k=0,W=c.length;k<W;k++){let N=c[k],V=N.color,Y=N.intensity,G=N.distance,ae=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===ji?ae=N.shadow.map.texture:ae=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=V.r*Y,f+=V.g*Y,h+=V.b*Y;else if(N.isLightProbe){for(let q=0;q<9;q++)i.probe[q].addScaledVector(N.sh.coefficients[q],Y);L++}else if(N.isSunLight){let q=e.get(N);if(q.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let K=N.shadow,ne=t.get(N);ne.shadowIntensity=K.intensity,ne.shadowBias=K.bias,ne.shadowNormalBias=K.normalBias,ne.shadowRadius=K.radius,ne.shadowMapSize.copy(K.mapSize).multiply(K.getFrameExtents()),i.sunShadow[g]=ne,i.sunShadowMap[g]=ae;let ue=K.getViewportCount();for(let he=0;he<ue;he++)i.sunShadowMatrix[y+he]=K.getMatrix(he),i.sunShadowCascade[y+he]=K._cascadeData[he];y+=ue,g++}i.sun[p]=q,p++}else if(N.isDirectionalLight){let q=e.get(N);if(q.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let K=N.shadow,ne=t.get(N);ne.shadowIntensity=K.intensity,ne.shadowBias=K.bias,ne.shadowNormalBias=K.normalBias,ne.shadowRadius=K.radius,ne.shadowMapSize=K.mapSize,i.directionalShadow[d]=ne,i.directionalShadowMap[d]=ae,i.directionalShadowMatrix[d]=N.shadow.matrix,C++}i.directional[d]=q,d++}else if(N.isSpotLight){let q=e.get(N);q.position.setFromMatrixPosition(N.matrixWorld),q.color.copy(V).multiplyScalar(Y),q.distance=G,q.coneCos=Math.cos(N.angle),q.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),q.decay=N.decay,i.spot[v]=q;let K=N.shadow;if(N.map&&(i.spotLightMap[w]=N.map,w++,K.updateMatrices(N),N.castShadow&&U++),i.spotLightMatrix[v]=K.matrix,N.castShadow){let ne=t.get(N);ne.shadowIntensity=K.intensity,ne.shadowBias=K.bias,ne.shadowNormalBias=K.normalBias,ne.shadowRadius=K.radius,ne.shadowMapSize=K.mapSize,i.spotShadow[v]=ne,i.spotShadowMap[v]=ae,_++}v++}else if(N.isRectAreaLight){let q=e.get(N);q.color.copy(V).multiplyScalar(Y),q.halfWidth.set(N.width*.5,0,0),q.halfHeight.set(0,N.height*.5,0),i.rectArea[T]=q,T++}else if(N.isPointLight){let q=e.get(N);if(q.color.copy(N.color).multiplyScalar(N.intensity),q.distance=N.distance,q.decay=N.decay,N.castShadow){let K=N.shadow,ne=t.get(N);ne.shadowIntensity=K.intensity,ne.shadowBias=K.bias,ne.shadowNormalBias=K.normalBias,ne.shadowRadius=K.radius,ne.shadowMapSize=K.mapSize,ne.shadowCameraNear=K.camera.near,ne.shadowCameraFar=K.camera.far,i.pointShadow[m]=ne,i.pointShadowMap[m]=ae,i.pointShadowMatrix[m]=N.shadow.matrix,A++}i.point[m]=q,m++}else if(N.isHemisphereLight){let q=e.get(N);q.skyColor.copy(N.color).multiplyScalar(Y),q.groundColor.copy(N.groundColor).multiplyScalar(Y),i.hemi[S]=q,S++}}T>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ne.LTC_FLOAT_1,i.rectAreaLTC2=Ne.LTC_FLOAT_2):(i.rectAreaLTC1=Ne.LTC_HALF_1,i.rectAreaLTC2=Ne.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let I=i.hash;(I.sunLength!==p||I.directionalLength!==d||I.pointLength!==m||I.spotLength!==v||I.rectAreaLength!==T||I.hemiLength!==S||I.numSunShadows!==g||I.numDirectionalShadows!==C||I.numPointShadows!==A||I.numSpotShadows!==_||I.numSpotMaps!==w||I.numLightProbes!==L)&&(i.sun.length=p,i.directional.length=d,i.spot.length=v,i.rectArea.length=T,i.point.length=m,i.hemi.length=S,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+w-U,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=L,I.sunLength=p,I.directionalLength=d,I.pointLength=m,I.spotLength=v,I.rectAreaLength=T,I.hemiLength=S,I.numSunShadows=g,I.numDirectionalShadows=C,I.numPointShadows=A,I.numSpotShadows=_,I.numSpotMaps=w,I.numLightProbes=L,i.version=nA++)}function l(c,u){let f=0,h=0,p=0,g=0,y=0,d=0,m=u.matrixWorldInverse;for(let v=0,T=c.length;v<T;v++){let S=c[v];if(S.isSunLight){let C=i.sun[f];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(m),f++}else if(S.isDirectionalLight){let C=i.directional[h];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),h++}else if(S.isSpotLight){let C=i.spot[g];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(m),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),g++}else if(S.isRectAreaLight){let C=i.rectArea[y];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let C=i.point[p];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(m),p++}else if(S.isHemisphereLight){let C=i.hemi[d];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(m),d++}}}return{setup:a,setupView:l,state:i}}function e0(n){let e=new sA(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function rA(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new e0(n),e.set(s,[a])):r>=o.length?(a=new e0(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var oA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,aA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,lA=[new B(1,0,0),new B(-1,0,0),new B(0,1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1)],cA=[new B(0,-1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1),new B(0,-1,0),new B(0,-1,0)],t0=new xt,rl=new B,sd=new B;function uA(n,e,t){let i=new sr,s=new lt,r=new lt,o=new Ht,a=new zc,l=new Gc,c={},u=t.maxTextureSize,f={[ur]:ii,[ii]:ur,[Ii]:Ii},h=new ci({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new lt},radius:{value:4}},vertexShader:oA,fragmentShader:aA}),p=h.clone();p.defines.HORIZONTAL_PASS=1;let g=new _n;g.setAttribute("position",new mn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Me(g,h),d=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Pr;let m=this.type;this.render=function(A,_,w){if(d.enabled===!1||d.autoUpdate===!1&&d.needsUpdate===!1||A.length===0)return;this.type===Zm&&(Ze("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Pr);let U=n.getRenderTarget(),L=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),k=n.state;k.setBlending(Ir),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let W=m!==this.type;W&&_.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(V=>V.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,V=A.length;N<V;N++){let Y=A[N],G=Y.shadow;if(G===void 0){Ze("WebGLShadowMap:",Y,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let ae=G.getFrameExtents();s.multiply(ae),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ae.x),s.x=r.x*ae.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ae.y),s.y=r.y*ae.y,G.mapSize.y=r.y));let q=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=q,G.map===null||W===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Oo){if(Y.isPointLight){Ze("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new vi(s.x,s.y,{format:ji,type:Ji,minFilter:ni,magFilter:ni,generateMipmaps:!1}),G.map.texture.name=Y.name+".shadowMap",G.map.depthTexture=new Ns(s.x,s.y,Li),G.map.depthTexture.name=Y.name+".shadowMapDepth",G.map.depthTexture.format=Is,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=kn,G.map.depthTexture.magFilter=kn}else Y.isPointLight?(G.map=new al(s.x),G.map.depthTexture=new Ba(s.x,Zi)):(G.map=new vi(s.x,s.y),G.map.depthTexture=new Ns(s.x,s.y,Zi)),G.map.depthTexture.name=Y.name+".shadowMap",G.map.depthTexture.format=Is,this.type===Pr?(G.map.depthTexture.compareFunction=q?$f:Yf,G.map.depthTexture.minFilter=ni,G.map.depthTexture.magFilter=ni):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=kn,G.map.depthTexture.magFilter=kn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let K=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();Y.isPointLight!==!0&&G.updateMatrices(Y,w);let ne=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:w.layers;for(let ue=0;ue<K;ue++){let he=G.getCamera(ue);if(Y.isPointLight){let Q=G.camera,me=G.matrix,xe=Y.distance||Q.far;xe!==Q.far&&(Q.far=xe,Q.updateProjectionMatrix()),rl.setFromMatrixPosition(Y.matrixWorld),Q.position.copy(rl),sd.copy(Q.position),sd.add(lA[ue]),Q.up.copy(cA[ue]),Q.lookAt(sd),Q.updateMatrixWorld(),me.makeTranslation(-rl.x,-rl.y,-rl.z),t0.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),G._frustum.setFromProjectionMatrix(t0,Q.coordinateSystem,Q.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,ue),n.clear();else{ue===0&&(n.setRenderTarget(G.map),n.clear());let Q=G.getViewport(ue);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),k.viewport(o)}i=G.getFrustum(ue),S(_,w,he,Y,ne,this.type)}G.isPointLightShadow!==!0&&this.type===Oo&&v(G,w),G.needsUpdate=!1}m=this.type,d.needsUpdate=!1,n.setRenderTarget(U,L,I)};function v(A,_){let w=e.update(y);h.defines.VSM_SAMPLES!==A.blurSamples&&(h.defines.VSM_SAMPLES=A.blurSamples,p.defines.VSM_SAMPLES=A.blurSamples,h.needsUpdate=!0,p.needsUpdate=!0),A.mapPass===null?A.mapPass=new vi(s.x,s.y,{format:ji,type:Ji}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),h.uniforms.shadow_pass.value=A.map.depthTexture,h.uniforms.resolution.value.set(A.map.width,A.map.height),h.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(_,null,w,h,y,null),p.uniforms.shadow_pass.value=A.mapPass.texture,p.uniforms.resolution.value.set(A.map.width,A.map.height),p.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(_,null,w,p,y,null)}function T(A,_,w,U){let L=null,I=w.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(I!==void 0)L=I;else if(L=w.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let k=L.uuid,W=_.uuid,N=c[k];N===void 0&&(N={},c[k]=N);let V=N[W];V===void 0&&(V=L.clone(),N[W]=V,_.addEventListener("dispose",C)),L=V}if(L.visible=_.visible,L.wireframe=_.wireframe,U===Oo?L.side=_.shadowSide!==null?_.shadowSide:_.side:L.side=_.shadowSide!==null?_.shadowSide:f[_.side],L.alphaMap=_.alphaMap,L.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,L.map=_.map,L.clipShadows=_.clipShadows,L.clippingPlanes=_.clippingPlanes,L.clipIntersection=_.clipIntersection,L.displacementMap=_.displacementMap,L.displacementScale=_.displacementScale,L.displacementBias=_.displacementBias,L.wireframeLinewidth=_.wireframeLinewidth,L.linewidth=_.linewidth,w.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let k=n.properties.get(L);k.light=w}return L}function S(A,_,w,U,L,I){if(A.visible===!1)return;if(A.layers.test(L)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&I===Oo)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,A.matrixWorld);let N=e.update(A),V=A.material;if(Array.isArray(V)){let Y=N.groups;for(let G=0,ae=Y.length;G<ae;G++){let q=Y[G],K=V[q.materialIndex];if(K&&K.visible){let ne=T(A,K,U,I);A.onBeforeShadow(n,A,_,w,N,ne,q),n.renderBufferDirect(w,null,N,ne,A,q),A.onAfterShadow(n,A,_,w,N,ne,q)}}}else if(V.visible){let Y=T(A,V,U,I);A.onBeforeShadow(n,A,_,w,N,Y,null),n.renderBufferDirect(w,null,N,Y,A,null),A.onAfterShadow(n,A,_,w,N,Y,null)}}let W=A.children;for(let N=0,V=W.length;N<V;N++)S(W[N],_,w,U,L,I)}function C(A){A.target.removeEventListener("dispose",C);for(let w in c){let U=c[w],L=A.target.uuid;L in U&&(U[L].dispose(),delete U[L])}}}function hA(n,e){function t(){let F=!1,se=new Ht,te=null,Ee=new Ht(0,0,0,0);return{setMask:function(ge){te!==ge&&!F&&(n.colorMask(ge,ge,ge,ge),te=ge)},setLocked:function(ge){F=ge},setClear:function(ge,Se,He,je,le){le===!0&&(ge*=je,Se*=je,He*=je),se.set(ge,Se,He,je),Ee.equals(se)===!1&&(n.clearColor(ge,Se,He,je),Ee.copy(se))},reset:function(){F=!1,te=null,Ee.set(-1,0,0,0)}}}function i(){let F=!1,se=!1,te=null,Ee=null,ge=null;return{setReversed:function(Se){if(se!==Se){let He=e.get("EXT_clip_control");Se?He.clipControlEXT(He.LOWER_LEFT_EXT,He.ZERO_TO_ONE_EXT):He.clipControlEXT(He.LOWER_LEFT_EXT,He.NEGATIVE_ONE_TO_ONE_EXT),se=Se;let je=ge;ge=null,this.setClear(je)}},getReversed:function(){return se},setTest:function(Se){Se?be(n.DEPTH_TEST):We(n.DEPTH_TEST)},setMask:function(Se){te!==Se&&!F&&(n.depthMask(Se),te=Se)},setFunc:function(Se){if(se&&(Se=Rg[Se]),Ee!==Se){switch(Se){case Sc:n.depthFunc(n.NEVER);break;case Mc:n.depthFunc(n.ALWAYS);break;case bc:n.depthFunc(n.LESS);break;case To:n.depthFunc(n.LEQUAL);break;case wc:n.depthFunc(n.EQUAL);break;case Ec:n.depthFunc(n.GEQUAL);break;case Ac:n.depthFunc(n.GREATER);break;case Tc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ee=Se}},setLocked:function(Se){F=Se},setClear:function(Se){ge!==Se&&(ge=Se,se&&(Se=1-Se),n.clearDepth(Se))},reset:function(){F=!1,te=null,Ee=null,ge=null,se=!1}}}function s(){let F=!1,se=null,te=null,Ee=null,ge=null,Se=null,He=null,je=null,le=null;return{setTest:function(Be){F||(Be?be(n.STENCIL_TEST):We(n.STENCIL_TEST))},setMask:function(Be){se!==Be&&!F&&(n.stencilMask(Be),se=Be)},setFunc:function(Be,Ke,Re){(te!==Be||Ee!==Ke||ge!==Re)&&(n.stencilFunc(Be,Ke,Re),te=Be,Ee=Ke,ge=Re)},setOp:function(Be,Ke,Re){(Se!==Be||He!==Ke||je!==Re)&&(n.stencilOp(Be,Ke,Re),Se=Be,He=Ke,je=Re)},setLocked:function(Be){F=Be},setClear:function(Be){le!==Be&&(n.clearStencil(Be),le=Be)},reset:function(){F=!1,se=null,te=null,Ee=null,ge=null,Se=null,He=null,je=null,le=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},p=new WeakMap,g=[],y=null,d=!1,m=null,v=null,T=null,S=null,C=null,A=null,_=null,w=new qe(0,0,0),U=0,L=!1,I=null,k=null,W=null,N=null,V=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ae=0,q=n.getParameter(n.VERSION);q.indexOf("WebGL")!==-1?(ae=parseFloat(/^WebGL (\d)/.exec(q)[1]),G=ae>=1):q.indexOf("OpenGL ES")!==-1&&(ae=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),G=ae>=2);let K=null,ne={},ue=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),Q=new Ht().fromArray(ue),me=new Ht().fromArray(he);function xe(F,se,te,Ee){let ge=new Uint8Array(4),Se=n.createTexture();n.bindTexture(F,Se),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let He=0;He<te;He++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(se,0,n.RGBA,1,1,Ee,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(se+He,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return Se}let Ce={};Ce[n.TEXTURE_2D]=xe(n.TEXTURE_2D,n.TEXTURE_2D,1),Ce[n.TEXTURE_CUBE_MAP]=xe(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ce[n.TEXTURE_2D_ARRAY]=xe(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ce[n.TEXTURE_3D]=xe(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),be(n.DEPTH_TEST),o.setFunc(To),xn(!1),Ut(Cf),be(n.CULL_FACE),Kt(Ir);function be(F){u[F]!==!0&&(n.enable(F),u[F]=!0)}function We(F){u[F]!==!1&&(n.disable(F),u[F]=!1)}function rt(F,se){return h[F]!==se?(n.bindFramebuffer(F,se),h[F]=se,F===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=se),F===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=se),!0):!1}function Ve(F,se){let te=g,Ee=!1;if(F){te=p.get(se),te===void 0&&(te=[],p.set(se,te));let ge=F.textures;if(te.length!==ge.length||te[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,He=ge.length;Se<He;Se++)te[Se]=n.COLOR_ATTACHMENT0+Se;te.length=ge.length,Ee=!0}}else te[0]!==n.BACK&&(te[0]=n.BACK,Ee=!0);Ee&&n.drawBuffers(te)}function ft(F){return y!==F?(n.useProgram(F),y=F,!0):!1}let ct={[Lr]:n.FUNC_ADD,[jm]:n.FUNC_SUBTRACT,[Km]:n.FUNC_REVERSE_SUBTRACT};ct[Qm]=n.MIN,ct[eg]=n.MAX;let it={[tg]:n.ZERO,[ng]:n.ONE,[ig]:n.SRC_COLOR,[Lf]:n.SRC_ALPHA,[cg]:n.SRC_ALPHA_SATURATE,[ag]:n.DST_COLOR,[rg]:n.DST_ALPHA,[sg]:n.ONE_MINUS_SRC_COLOR,[Nf]:n.ONE_MINUS_SRC_ALPHA,[lg]:n.ONE_MINUS_DST_COLOR,[og]:n.ONE_MINUS_DST_ALPHA,[ug]:n.CONSTANT_COLOR,[hg]:n.ONE_MINUS_CONSTANT_COLOR,[fg]:n.CONSTANT_ALPHA,[dg]:n.ONE_MINUS_CONSTANT_ALPHA};function Kt(F,se,te,Ee,ge,Se,He,je,le,Be){if(F===Ir){d===!0&&(We(n.BLEND),d=!1);return}if(d===!1&&(be(n.BLEND),d=!0),F!==Jm){if(F!==m||Be!==L){if((v!==Lr||C!==Lr)&&(n.blendEquation(n.FUNC_ADD),v=Lr,C=Lr),Be)switch(F){case Bo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Rf:n.blendFunc(n.ONE,n.ONE);break;case Pf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case If:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Qe("WebGLState: Invalid blending: ",F);break}else switch(F){case Bo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Rf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Pf:Qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case If:Qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qe("WebGLState: Invalid blending: ",F);break}T=null,S=null,A=null,_=null,w.set(0,0,0),U=0,m=F,L=Be}return}ge=ge||se,Se=Se||te,He=He||Ee,(se!==v||ge!==C)&&(n.blendEquationSeparate(ct[se],ct[ge]),v=se,C=ge),(te!==T||Ee!==S||Se!==A||He!==_)&&(n.blendFuncSeparate(it[te],it[Ee],it[Se],it[He]),T=te,S=Ee,A=Se,_=He),(je.equals(w)===!1||le!==U)&&(n.blendColor(je.r,je.g,je.b,le),w.copy(je),U=le),m=F,L=!1}function Vt(F,se){F.side===Ii?We(n.CULL_FACE):be(n.CULL_FACE);let te=F.side===ii;se&&(te=!te),xn(te),F.blending===Bo&&F.transparent===!1?Kt(Ir):Kt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let Ee=F.stencilWrite;a.setTest(Ee),Ee&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),St(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?be(n.SAMPLE_ALPHA_TO_COVERAGE):We(n.SAMPLE_ALPHA_TO_COVERAGE)}function xn(F){I!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),I=F)}function Ut(F){F!==Ym?(be(n.CULL_FACE),F!==k&&(F===Cf?n.cullFace(n.BACK):F===$m?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):We(n.CULL_FACE),k=F}function Nn(F){F!==W&&(G&&n.lineWidth(F),W=F)}function St(F,se,te){F?(be(n.POLYGON_OFFSET_FILL),(N!==se||V!==te)&&(N=se,V=te,o.getReversed()&&(se=-se,te=-te),n.polygonOffset(se,te))):We(n.POLYGON_OFFSET_FILL)}function Tn(F){F?be(n.SCISSOR_TEST):We(n.SCISSOR_TEST)}function sn(F){F===void 0&&(F=n.TEXTURE0+Y-1),K!==F&&(n.activeTexture(F),K=F)}function vn(F,se,te){te===void 0&&(K===null?te=n.TEXTURE0+Y-1:te=K);let Ee=ne[te];Ee===void 0&&(Ee={type:void 0,texture:void 0},ne[te]=Ee),(Ee.type!==F||Ee.texture!==se)&&(K!==te&&(n.activeTexture(te),K=te),n.bindTexture(F,se||Ce[F]),Ee.type=F,Ee.texture=se)}function O(){let F=ne[K];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Pe(){try{n.compressedTexImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function $e(){try{n.compressedTexImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function ot(){try{n.texSubImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function we(){try{n.texSubImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function Ot(){try{n.compressedTexSubImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function Ge(){try{n.compressedTexSubImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function Ye(){try{n.texStorage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function R(){try{n.texStorage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function M(){try{n.texImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function X(){try{n.texImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function ce(F){return f[F]!==void 0?f[F]:n.getParameter(F)}function re(F,se){f[F]!==se&&(n.pixelStorei(F,se),f[F]=se)}function _e(F){Q.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),Q.copy(F))}function ve(F){me.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),me.copy(F))}function ee(F,se){let te=c.get(se);te===void 0&&(te=new WeakMap,c.set(se,te));let Ee=te.get(F);Ee===void 0&&(Ee=n.getUniformBlockIndex(se,F.name),n.uniformBlockBinding(se,Ee,Ee),te.set(F,Ee))}function ie(F,se,te){let ge=c.get(se).get(F);l[ge]!==te&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,te),l[ge]=te)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},K=null,ne={},h={},l={},p=new WeakMap,g=[],y=null,d=!1,m=null,v=null,T=null,S=null,C=null,A=null,_=null,w=new qe(0,0,0),U=0,L=!1,I=null,k=null,W=null,N=null,V=null,Q.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:be,disable:We,bindFramebuffer:rt,drawBuffers:Ve,useProgram:ft,setBlending:Kt,setMaterial:Vt,setFlipSided:xn,setCullFace:Ut,setLineWidth:Nn,setPolygonOffset:St,setScissorTest:Tn,activeTexture:sn,bindTexture:vn,unbindTexture:O,compressedTexImage2D:Pe,compressedTexImage3D:$e,texImage2D:M,texImage3D:X,pixelStorei:re,getParameter:ce,updateUBOMapping:ee,uniformBlockBinding:ie,texStorage2D:Ye,texStorage3D:R,texSubImage2D:ot,texSubImage3D:we,compressedTexSubImage2D:Ot,compressedTexSubImage3D:Ge,scissor:_e,viewport:ve,reset:pe}}function fA(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new lt,u=new WeakMap,f=new Set,h,p=new WeakMap,g=new Set,y=new FinalizationRegistry(R=>g.delete(R)),d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,M){return d?new OffscreenCanvas(R,M):Ra("canvas")}function v(R,M,X){let ce=1,re=Ye(R);if((re.width>X||re.height>X)&&(ce=X/Math.max(re.width,re.height)),ce<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let _e=Math.floor(ce*re.width),ve=Math.floor(ce*re.height);h===void 0&&(h=m(_e,ve));let ee=M?m(_e,ve):h;return ee.width=_e,ee.height=ve,ee.getContext("2d").drawImage(R,0,0,_e,ve),Ze("WebGLRenderer: Texture has been resized from ("+re.width+"x"+re.height+") to ("+_e+"x"+ve+")."),ee}else return"data"in R&&Ze("WebGLRenderer: Image in DataTexture is too big ("+re.width+"x"+re.height+")."),R;return R}function T(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(R,M,X,ce,re,_e=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ze("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ve;ce&&(ve=e.get("EXT_texture_norm16"),ve||Ze("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ee=M;if(M===n.RED&&(X===n.FLOAT&&(ee=n.R32F),X===n.HALF_FLOAT&&(ee=n.R16F),X===n.UNSIGNED_BYTE&&(ee=n.R8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.R16_EXT),X===n.SHORT&&ve&&(ee=ve.R16_SNORM_EXT)),M===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.R8UI),X===n.UNSIGNED_SHORT&&(ee=n.R16UI),X===n.UNSIGNED_INT&&(ee=n.R32UI),X===n.BYTE&&(ee=n.R8I),X===n.SHORT&&(ee=n.R16I),X===n.INT&&(ee=n.R32I)),M===n.RG&&(X===n.FLOAT&&(ee=n.RG32F),X===n.HALF_FLOAT&&(ee=n.RG16F),X===n.UNSIGNED_BYTE&&(ee=n.RG8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RG16_EXT),X===n.SHORT&&ve&&(ee=ve.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RG8UI),X===n.UNSIGNED_SHORT&&(ee=n.RG16UI),X===n.UNSIGNED_INT&&(ee=n.RG32UI),X===n.BYTE&&(ee=n.RG8I),X===n.SHORT&&(ee=n.RG16I),X===n.INT&&(ee=n.RG32I)),M===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGB8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGB16UI),X===n.UNSIGNED_INT&&(ee=n.RGB32UI),X===n.BYTE&&(ee=n.RGB8I),X===n.SHORT&&(ee=n.RGB16I),X===n.INT&&(ee=n.RGB32I)),M===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGBA16UI),X===n.UNSIGNED_INT&&(ee=n.RGBA32UI),X===n.BYTE&&(ee=n.RGBA8I),X===n.SHORT&&(ee=n.RGBA16I),X===n.INT&&(ee=n.RGBA32I)),M===n.RGB&&(X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RGB16_EXT),X===n.SHORT&&ve&&(ee=ve.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(ee=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(ee=n.R11F_G11F_B10F)),M===n.RGBA){let ie=_e?Ca:_t.getTransfer(re);X===n.FLOAT&&(ee=n.RGBA32F),X===n.HALF_FLOAT&&(ee=n.RGBA16F),X===n.UNSIGNED_BYTE&&(ee=ie===Tt?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RGBA16_EXT),X===n.SHORT&&ve&&(ee=ve.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(ee=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(ee=n.RGB5_A1)}return(ee===n.R16F||ee===n.R32F||ee===n.RG16F||ee===n.RG32F||ee===n.RGBA16F||ee===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function _(R,M){let X;return R?M===null||M===Zi||M===Dr?X=n.DEPTH24_STENCIL8:M===Li?X=n.DEPTH32F_STENCIL8:M===zo&&(X=n.DEPTH24_STENCIL8,Ze("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Zi||M===Dr?X=n.DEPTH_COMPONENT24:M===Li?X=n.DEPTH_COMPONENT32F:M===zo&&(X=n.DEPTH_COMPONENT16),X}function w(R,M){return T(R)===!0||R.isFramebufferTexture&&R.minFilter!==kn&&R.minFilter!==ni?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function U(R){let M=new WeakRef(R);i.get(R).__ref=M,g.add(M),y.register(R,M,M)}function L(R){let M=i.get(R).__ref;M!==void 0&&(g.delete(M),y.unregister(M))}function I(R){W(R.target)}function k(R){N(R.target)}function W(R){R.removeEventListener("dispose",I),L(R),Y(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&f.delete(R)}function N(R){R.removeEventListener("dispose",k),L(R),ae(R)}function V(){for(let R of g){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?N(M):W(M))}g.clear(),f.clear()}function Y(R){let M=i.get(R);if(M.__webglInit===void 0)return;let X=R.source,ce=p.get(X);if(ce){let re=ce[M.__cacheKey];re.usedTimes--,re.usedTimes===0&&G(R),Object.keys(ce).length===0&&p.delete(X)}i.remove(R)}function G(R){let M=i.get(R);n.deleteTexture(M.__webglTexture);let X=R.source,ce=p.get(X);delete ce[M.__cacheKey],o.memory.textures--}function ae(R){let M=i.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let X=R.depthTexture;if(X&&X.renderTarget===R&&W(X),R.isWebGLCubeRenderTarget)for(let re=0;re<6;re++){if(Array.isArray(M.__webglFramebuffer[re]))for(let _e=0;_e<M.__webglFramebuffer[re].length;_e++)n.deleteFramebuffer(M.__webglFramebuffer[re][_e]);else n.deleteFramebuffer(M.__webglFramebuffer[re]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[re])}else{if(Array.isArray(M.__webglFramebuffer))for(let re=0;re<M.__webglFramebuffer.length;re++)n.deleteFramebuffer(M.__webglFramebuffer[re]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let re=0;re<M.__webglColorRenderbuffer.length;re++)M.__webglColorRenderbuffer[re]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[re]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ce=R.textures;for(let re=0,_e=ce.length;re<_e;re++){let ve=i.get(ce[re]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(ce[re])}i.remove(R)}let q=0;function K(){q=0}function ne(){return q}function ue(R){q=R}function he(){let R=q;return R>=s.maxTextures&&Ze("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,R}function Q(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function me(R,M){let X=i.get(R);if(R.isVideoTexture&&Ot(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&X.__version!==R.version){let ce=R.image;if(ce===null)Ze("WebGLRenderer: Texture marked for update but no image data found.");else if(ce.complete===!1)Ze("WebGLRenderer: Texture marked for update but image is incomplete");else{Vt(X,R,M);return}}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+M)}function xe(R,M){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){Vt(X,R,M);return}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+M)}function Ce(R,M){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){Vt(X,R,M);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+M)}function be(R,M){let X=i.get(R);if(R.version>0&&X.__version!==R.version){xn(X,R,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+M)}let We={[Cc]:n.REPEAT,[hs]:n.CLAMP_TO_EDGE,[Rc]:n.MIRRORED_REPEAT},rt={[kn]:n.NEAREST,[gg]:n.NEAREST_MIPMAP_NEAREST,[Ja]:n.NEAREST_MIPMAP_LINEAR,[ni]:n.LINEAR,[iu]:n.LINEAR_MIPMAP_NEAREST,[Fs]:n.LINEAR_MIPMAP_LINEAR},Ve={[yg]:n.NEVER,[Zf]:n.ALWAYS,[Sg]:n.LESS,[Yf]:n.LEQUAL,[Mg]:n.EQUAL,[$f]:n.GEQUAL,[bg]:n.GREATER,[wg]:n.NOTEQUAL};function ft(R,M){if(M.type===Li&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===ni||M.magFilter===iu||M.magFilter===Ja||M.magFilter===Fs||M.minFilter===ni||M.minFilter===iu||M.minFilter===Ja||M.minFilter===Fs)&&Ze("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,We[M.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,We[M.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,We[M.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,rt[M.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,rt[M.minFilter]),M.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Ve[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===kn||M.minFilter!==Ja&&M.minFilter!==Fs||M.type===Li&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ct(R,M){let X=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",I),U(M));let ce=M.source,re=p.get(ce);re===void 0&&(re={},p.set(ce,re));let _e=Q(M);if(_e!==R.__cacheKey){re[_e]===void 0&&(re[_e]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),re[_e].usedTimes++;let ve=re[R.__cacheKey];ve!==void 0&&(re[R.__cacheKey].usedTimes--,ve.usedTimes===0&&G(M)),R.__cacheKey=_e,R.__webglTexture=re[_e].texture}return X}function it(R,M,X){return Math.floor(Math.floor(R/X)/M)}function Kt(R,M,X,ce){let _e=R.updateRanges;if(_e.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,X,ce,M.data);else{_e.sort((F,se)=>F.start-se.start);let ve=0;for(let F=1;F<_e.length;F++){let se=_e[ve],te=_e[F],Ee=se.start+se.count,ge=it(te.start,M.width,4),Se=it(se.start,M.width,4);te.start<=Ee+1&&ge===Se&&it(te.start+te.count-1,M.width,4)===ge?se.count=Math.max(se.count,te.start+te.count-se.start):(++ve,_e[ve]=te)}_e.length=ve+1;let ee=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let F=0,se=_e.length;F<se;F++){let te=_e[F],Ee=Math.floor(te.start/4),ge=Math.ceil(te.count/4),Se=Ee%M.width,He=Math.floor(Ee/M.width),je=ge,le=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,He),t.texSubImage2D(n.TEXTURE_2D,0,Se,He,je,le,X,ce,M.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ee),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Vt(R,M,X){let ce=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ce=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ce=n.TEXTURE_3D);let re=ct(R,M),_e=M.source;t.bindTexture(ce,R.__webglTexture,n.TEXTURE0+X);let ve=i.get(_e);if(_e.version!==ve.__version||re===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let le=_t.getPrimaries(_t.workingColorSpace),Be=M.colorSpace===Bs?null:_t.getPrimaries(M.colorSpace),Ke=M.colorSpace===Bs||le===Be?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ke)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let ie=v(M.image,!1,s.maxTextureSize);ie=Ge(M,ie);let pe=r.convert(M.format,M.colorSpace),F=r.convert(M.type),se=A(M.internalFormat,pe,F,M.normalized,M.colorSpace,M.isVideoTexture);ft(ce,M);let te,Ee=M.mipmaps,ge=M.isVideoTexture!==!0,Se=ve.__version===void 0||re===!0,He=_e.dataReady,je=w(M,ie);if(M.isDepthTexture)se=_(M.format===Os,M.type),Se&&(ge?t.texStorage2D(n.TEXTURE_2D,1,se,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,se,ie.width,ie.height,0,pe,F,null));else if(M.isDataTexture)if(Ee.length>0){ge&&Se&&t.texStorage2D(n.TEXTURE_2D,je,se,Ee[0].width,Ee[0].height);for(let le=0,Be=Ee.length;le<Be;le++)te=Ee[le],ge?He&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,te.width,te.height,pe,F,te.data):t.texImage2D(n.TEXTURE_2D,le,se,te.width,te.height,0,pe,F,te.data);M.generateMipmaps=!1}else ge?(Se&&t.texStorage2D(n.TEXTURE_2D,je,se,ie.width,ie.height),He&&Kt(M,ie,pe,F)):t.texImage2D(n.TEXTURE_2D,0,se,ie.width,ie.height,0,pe,F,ie.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){ge&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,se,Ee[0].width,Ee[0].height,ie.depth);for(let le=0,Be=Ee.length;le<Be;le++)if(te=Ee[le],M.format!==ui)if(pe!==null)if(ge){if(He)if(M.layerUpdates.size>0){let Ke=nd(te.width,te.height,M.format,M.type);for(let Re of M.layerUpdates){let at=te.data.subarray(Re*Ke/te.data.BYTES_PER_ELEMENT,(Re+1)*Ke/te.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,Re,te.width,te.height,1,pe,at)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,te.width,te.height,ie.depth,pe,te.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,le,se,te.width,te.height,ie.depth,0,te.data,0,0);else Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?He&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,te.width,te.height,ie.depth,pe,F,te.data):t.texImage3D(n.TEXTURE_2D_ARRAY,le,se,te.width,te.height,ie.depth,0,pe,F,te.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{ge&&Se&&t.texStorage2D(n.TEXTURE_2D,je,se,Ee[0].width,Ee[0].height);for(let le=0,Be=Ee.length;le<Be;le++)te=Ee[le],M.format!==ui?pe!==null?ge?He&&t.compressedTexSubImage2D(n.TEXTURE_2D,le,0,0,te.width,te.height,pe,te.data):t.compressedTexImage2D(n.TEXTURE_2D,le,se,te.width,te.height,0,te.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?He&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,te.width,te.height,pe,F,te.data):t.texImage2D(n.TEXTURE_2D,le,se,te.width,te.height,0,pe,F,te.data)}else if(M.isDataArrayTexture)if(ge){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,se,ie.width,ie.height,ie.depth),He)if(M.layerUpdates.size>0){let le=nd(ie.width,ie.height,M.format,M.type);for(let Be of M.layerUpdates){let Ke=ie.data.subarray(Be*le/ie.data.BYTES_PER_ELEMENT,(Be+1)*le/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Be,ie.width,ie.height,1,pe,F,Ke)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,pe,F,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,se,ie.width,ie.height,ie.depth,0,pe,F,ie.data);else if(M.isData3DTexture)ge?(Se&&t.texStorage3D(n.TEXTURE_3D,je,se,ie.width,ie.height,ie.depth),He&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,pe,F,ie.data)):t.texImage3D(n.TEXTURE_3D,0,se,ie.width,ie.height,ie.depth,0,pe,F,ie.data);else if(M.isFramebufferTexture){if(Se)if(ge)t.texStorage2D(n.TEXTURE_2D,je,se,ie.width,ie.height);else{let le=ie.width,Be=ie.height;for(let Ke=0;Ke<je;Ke++)t.texImage2D(n.TEXTURE_2D,Ke,se,le,Be,0,pe,F,null),le>>=1,Be>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let le=n.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),ie.parentNode!==le){le.appendChild(ie),f.add(M),le.onpaint=Be=>{let Ke=Be.changedElements;for(let Re of f)Ke.includes(Re.image)&&(Re.needsUpdate=!0)},le.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let Ke=n.RGBA,Re=n.RGBA,at=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Ke,Re,at,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(ge&&Se){let le=Ye(Ee[0]);t.texStorage2D(n.TEXTURE_2D,je,se,le.width,le.height)}for(let le=0,Be=Ee.length;le<Be;le++)te=Ee[le],ge?He&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,pe,F,te):t.texImage2D(n.TEXTURE_2D,le,se,pe,F,te);M.generateMipmaps=!1}else if(ge){if(Se){let le=Ye(ie);t.texStorage2D(n.TEXTURE_2D,je,se,le.width,le.height)}He&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,F,ie)}else t.texImage2D(n.TEXTURE_2D,0,se,pe,F,ie);T(M)&&M.mipmapsAutoUpdate===!0&&S(ce),ve.__version=_e.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function xn(R,M,X){if(M.image.length!==6)return;let ce=ct(R,M),re=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+X);let _e=i.get(re);if(re.version!==_e.__version||ce===!0){t.activeTexture(n.TEXTURE0+X);let ve=_t.getPrimaries(_t.workingColorSpace),ee=M.colorSpace===Bs?null:_t.getPrimaries(M.colorSpace),ie=M.colorSpace===Bs||ve===ee?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let pe=M.isCompressedTexture||M.image[0].isCompressedTexture,F=M.image[0]&&M.image[0].isDataTexture,se=[];for(let Re=0;Re<6;Re++)!pe&&!F?se[Re]=v(M.image[Re],!0,s.maxCubemapSize):se[Re]=F?M.image[Re].image:M.image[Re],se[Re]=Ge(M,se[Re]);let te=se[0],Ee=r.convert(M.format,M.colorSpace),ge=r.convert(M.type),Se=A(M.internalFormat,Ee,ge,M.normalized,M.colorSpace),He=M.isVideoTexture!==!0,je=_e.__version===void 0||ce===!0,le=re.dataReady,Be=w(M,te);ft(n.TEXTURE_CUBE_MAP,M);let Ke;if(M.isDepthTexture){if(Se=_(M.format===Os,M.type),je)if(He)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,te.width,te.height);else for(let Re=0;Re<6;Re++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,te.width,te.height,0,Ee,ge,null)}else if(pe){He&&je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,te.width,te.height);for(let Re=0;Re<6;Re++){Ke=se[Re].mipmaps;for(let at=0;at<Ke.length;at++){let qt=Ke[at];M.format!==ui?Ee!==null?He?le&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,at,0,0,qt.width,qt.height,Ee,qt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,at,Se,qt.width,qt.height,0,qt.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):He?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,at,0,0,qt.width,qt.height,Ee,ge,qt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,at,Se,qt.width,qt.height,0,Ee,ge,qt.data)}}}else{if(Ke=M.mipmaps,He&&je){Ke.length>0&&Be++;let Re=Ye(se[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(F){He?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,se[Re].width,se[Re].height,Ee,ge,se[Re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,se[Re].width,se[Re].height,0,Ee,ge,se[Re].data);for(let at=0;at<Ke.length;at++){let Zn=Ke[at].image[Re].image;He?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,at+1,0,0,Zn.width,Zn.height,Ee,ge,Zn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,at+1,Se,Zn.width,Zn.height,0,Ee,ge,Zn.data)}}else{He?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,Ee,ge,se[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,Ee,ge,se[Re]);for(let at=0;at<Ke.length;at++){let qt=Ke[at];He?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,at+1,0,0,Ee,ge,qt.image[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,at+1,Se,Ee,ge,qt.image[Re])}}}T(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),_e.__version=re.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function Ut(R,M,X,ce,re,_e){let ve=r.convert(X.format,X.colorSpace),ee=r.convert(X.type),ie=A(X.internalFormat,ve,ee,X.normalized,X.colorSpace),pe=i.get(M),F=i.get(X);if(F.__renderTarget=M,!pe.__hasExternalTextures){let se=Math.max(1,M.width>>_e),te=Math.max(1,M.height>>_e);re===n.TEXTURE_3D||re===n.TEXTURE_2D_ARRAY?t.texImage3D(re,_e,ie,se,te,M.depth,0,ve,ee,null):t.texImage2D(re,_e,ie,se,te,0,ve,ee,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),we(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ce,re,F.__webglTexture,0,ot(M)):(re===n.TEXTURE_2D||re>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&re<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ce,re,F.__webglTexture,_e),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Nn(R,M,X){if(n.bindRenderbuffer(n.RENDERBUFFER,R),M.depthBuffer){let ce=M.depthTexture,re=ce&&ce.isDepthTexture?ce.type:null,_e=_(M.stencilBuffer,re),ve=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(M),_e,M.width,M.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(M),_e,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,_e,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,R)}else{let ce=M.textures;for(let re=0;re<ce.length;re++){let _e=ce[re],ve=r.convert(_e.format,_e.colorSpace),ee=r.convert(_e.type),ie=A(_e.internalFormat,ve,ee,_e.normalized,_e.colorSpace);we(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(M),ie,M.width,M.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(M),ie,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,ie,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function St(R,M,X){let ce=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let re=i.get(M.depthTexture);re.__renderTarget=M;let _e=ce?M.depthTexture.image[0]:M.depthTexture.image;(!re.__webglTexture||_e.width!==M.width||_e.height!==M.height)&&(_e.width=M.width,_e.height=M.height,M.depthTexture.needsUpdate=!0),ce?be(M.depthTexture,0):me(M.depthTexture,0);let ve=re.__webglTexture,ee=ot(M),ie=ce?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,pe=M.depthTexture.format===Os?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===Is)we(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ve,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ve,0);else if(M.depthTexture.format===Os)we(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ve,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Tn(R){let M=i.get(R),X=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ce=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ce){let re=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ce.removeEventListener("dispose",re)};ce.addEventListener("dispose",re),M.__depthDisposeCallback=re}M.__boundDepthTexture=ce}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(X)for(let ce=0;ce<6;ce++)St(M.__webglFramebuffer[ce],R,ce);else R.texture.mipmaps.length>0?St(M.__webglFramebuffer[0],R,0):St(M.__webglFramebuffer,R,0);else if(X){M.__webglDepthbuffer=[];for(let ce=0;ce<6;ce++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ce]),M.__webglDepthbuffer[ce]===void 0)M.__webglDepthbuffer[ce]=n.createRenderbuffer(),Nn(M.__webglDepthbuffer[ce],R,!1);else{let re=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer[ce];n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,re,n.RENDERBUFFER,_e)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),Nn(M.__webglDepthbuffer,R,!1);else{let re=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,re,n.RENDERBUFFER,_e)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function sn(R,M,X){let ce=i.get(R);M!==void 0&&Ut(ce.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&Tn(R)}function vn(R){let M=R.texture,X=i.get(R),ce=i.get(M);R.addEventListener("dispose",k),U(R);let re=R.textures,_e=R.isWebGLCubeRenderTarget===!0,ve=re.length>1;if(ve||(ce.__webglTexture===void 0&&(ce.__webglTexture=n.createTexture()),ce.__version=M.version,o.memory.textures++),_e){X.__webglFramebuffer=[];for(let ee=0;ee<6;ee++)if(M.mipmaps.length>0){X.__webglFramebuffer[ee]=[];for(let ie=0;ie<M.mipmaps.length;ie++)X.__webglFramebuffer[ee][ie]=n.createFramebuffer()}else X.__webglFramebuffer[ee]=n.createFramebuffer()}else{if(M.mipmaps.length>0){X.__webglFramebuffer=[];for(let ee=0;ee<M.mipmaps.length;ee++)X.__webglFramebuffer[ee]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(ve)for(let ee=0,ie=re.length;ee<ie;ee++){let pe=i.get(re[ee]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&we(R)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let ee=0;ee<re.length;ee++){let ie=re[ee];X.__webglColorRenderbuffer[ee]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[ee]);let pe=r.convert(ie.format,ie.colorSpace),F=r.convert(ie.type),se=A(ie.internalFormat,pe,F,ie.normalized,ie.colorSpace,R.isXRRenderTarget===!0),te=ot(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,te,se,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ee,n.RENDERBUFFER,X.__webglColorRenderbuffer[ee])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),Nn(X.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_e){t.bindTexture(n.TEXTURE_CUBE_MAP,ce.__webglTexture),ft(n.TEXTURE_CUBE_MAP,M);for(let ee=0;ee<6;ee++)if(M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ut(X.__webglFramebuffer[ee][ie],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,ie);else Ut(X.__webglFramebuffer[ee],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,0);T(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ee=0,ie=re.length;ee<ie;ee++){let pe=re[ee],F=i.get(pe),se=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(se=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(se,F.__webglTexture),ft(se,pe),Ut(X.__webglFramebuffer,R,pe,n.COLOR_ATTACHMENT0+ee,se,0),T(pe)&&S(se)}t.unbindTexture()}else{let ee=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ee=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ee,ce.__webglTexture),ft(ee,M),M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ut(X.__webglFramebuffer[ie],R,M,n.COLOR_ATTACHMENT0,ee,ie);else Ut(X.__webglFramebuffer,R,M,n.COLOR_ATTACHMENT0,ee,0);T(M)?S(ee):M.mipmaps.length>0&&n.texParameteri(ee,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Tn(R)}function O(R){let M=R.textures;for(let X=0,ce=M.length;X<ce;X++){let re=M[X];if(T(re)&&re.mipmapsAutoUpdate===!0){let _e=C(R),ve=i.get(re).__webglTexture;t.bindTexture(_e,ve),S(_e),t.unbindTexture()}}}let Pe=[];function $e(R){if(R.samples>0){if(we(R)===!1){let M=R.textures,X=R.width,ce=R.height,re=n.COLOR_BUFFER_BIT,_e=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(R),ee=M.length>1;if(ee)for(let pe=0;pe<M.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let pe=0;pe<M.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(re|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(re|=n.STENCIL_BUFFER_BIT)),ee){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let F=i.get(M[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,X,ce,0,0,X,ce,re,n.NEAREST),l===!0&&(Pe.length=0,Pe.push(n.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Pe.push(_e),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ee)for(let pe=0;pe<M.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let F=i.get(M[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,F,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let M=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function ot(R){return Math.min(s.maxSamples,R.samples)}function we(R){let M=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Ot(R){let M=o.render.frame;u.get(R)!==M&&(u.set(R,M),R.update())}function Ge(R,M){let X=R.colorSpace,ce=R.format,re=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||X!==Ta&&X!==Bs&&(_t.getTransfer(X)===Tt?(ce!==ui||re!==Xn)&&Ze("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qe("WebGLTextures: Unsupported texture color space:",X)),M}function Ye(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=K,this.getTextureUnits=ne,this.setTextureUnits=ue,this.setTexture2D=me,this.setTexture2DArray=xe,this.setTexture3D=Ce,this.setTextureCube=be,this.rebindTextures=sn,this.setupRenderTarget=vn,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=$e,this.setupDepthRenderbuffer=Tn,this.setupFrameBufferTexture=Ut,this.useMultisampledRTT=we,this.dispose=V}function dA(n,e){function t(i,s=Bs){let r,o=_t.getTransfer(s);if(i===Xn)return n.UNSIGNED_BYTE;if(i===ru)return n.UNSIGNED_SHORT_4_4_4_4;if(i===ou)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Hf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Wf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Gf)return n.BYTE;if(i===Vf)return n.SHORT;if(i===zo)return n.UNSIGNED_SHORT;if(i===su)return n.INT;if(i===Zi)return n.UNSIGNED_INT;if(i===Li)return n.FLOAT;if(i===Ji)return n.HALF_FLOAT;if(i===Xf)return n.ALPHA;if(i===qf)return n.RGB;if(i===ui)return n.RGBA;if(i===Is)return n.DEPTH_COMPONENT;if(i===Os)return n.DEPTH_STENCIL;if(i===Go)return n.RED;if(i===au)return n.RED_INTEGER;if(i===ji)return n.RG;if(i===lu)return n.RG_INTEGER;if(i===cu)return n.RGBA_INTEGER;if(i===ja||i===Ka||i===Qa||i===el)if(o===Tt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ja)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ka)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===el)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ja)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ka)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Qa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===el)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===uu||i===hu||i===fu||i===du)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===uu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===hu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===fu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===du)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===pu||i===mu||i===gu||i===_u||i===xu||i===tl||i===vu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===pu||i===mu)return o===Tt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===gu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===_u)return r.COMPRESSED_R11_EAC;if(i===xu)return r.COMPRESSED_SIGNED_R11_EAC;if(i===tl)return r.COMPRESSED_RG11_EAC;if(i===vu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===yu||i===Su||i===Mu||i===bu||i===wu||i===Eu||i===Au||i===Tu||i===Cu||i===Ru||i===Pu||i===Iu||i===Lu||i===Nu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===yu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Su)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Mu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===bu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===wu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Eu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Au)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Tu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Cu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ru)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Pu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Iu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Lu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Nu)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Du||i===Uu||i===Fu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Du)return o===Tt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Uu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Fu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Ou||i===Bu||i===nl||i===ku)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Ou)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Bu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===nl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===ku)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Dr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var pA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,mA=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,hd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new ka(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new ci({vertexShader:pA,fragmentShader:mA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Me(new Us(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},fd=class extends Xi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,p=null,g=null,y=typeof XRWebGLBinding<"u",d=new hd,m={},v=t.getContextAttributes(),T=null,S=null,C=[],A=[],_=new lt,w=null,U=null,L=new ti;L.viewport=new Ht;let I=new ti;I.viewport=new Ht;let k=[L,I],W=new Qc,N=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let me=C[Q];return me===void 0&&(me=new Lo,C[Q]=me),me.getTargetRaySpace()},this.getControllerGrip=function(Q){let me=C[Q];return me===void 0&&(me=new Lo,C[Q]=me),me.getGripSpace()},this.getHand=function(Q){let me=C[Q];return me===void 0&&(me=new Lo,C[Q]=me),me.getHandSpace()};function Y(Q){let me=A.indexOf(Q.inputSource);if(me===-1)return;let xe=C[me];xe!==void 0&&(xe.update(Q.inputSource,Q.frame,c||o),xe.dispatchEvent({type:Q.type,data:Q.inputSource}))}function G(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",ae);for(let Q=0;Q<C.length;Q++){let me=A[Q];me!==null&&(A[Q]=null,C[Q].disconnect(me))}N=null,V=null,d.reset();for(let Q in m)delete m[Q];if(e.setRenderTarget(T),p=null,h=null,f=null,s=null,S=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(_.width,_.height,!1),U!==null){let Q=U.camera;Q.fov=U.fov,Q.zoom=U.zoom,Q.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&Ze("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&Ze("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return h!==null?h:p},this.getBinding=function(){return f===null&&y&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(T=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",G),s.addEventListener("inputsourceschange",ae),v.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,Ce=null,be=null;v.depth&&(be=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=v.stencil?Os:Is,Ce=v.stencil?Dr:Zi);let We={colorFormat:t.RGBA8,depthFormat:be,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(We),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),S=new vi(h.textureWidth,h.textureHeight,{format:ui,type:Xn,depthTexture:new Ns(h.textureWidth,h.textureHeight,Ce,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let xe={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),S=new vi(p.framebufferWidth,p.framebufferHeight,{format:ui,type:Xn,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return d.getDepthTexture()};function ae(Q){for(let me=0;me<Q.removed.length;me++){let xe=Q.removed[me],Ce=A.indexOf(xe);Ce>=0&&(A[Ce]=null,C[Ce].disconnect(xe))}for(let me=0;me<Q.added.length;me++){let xe=Q.added[me],Ce=A.indexOf(xe);if(Ce===-1){for(let We=0;We<C.length;We++)if(We>=A.length){A.push(xe),Ce=We;break}else if(A[We]===null){A[We]=xe,Ce=We;break}if(Ce===-1)break}let be=C[Ce];be&&be.connect(xe)}}function q(Q,me){me===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(me.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let me=Q.near,xe=Q.far;d.texture!==null&&(d.depthNear>0&&(me=d.depthNear),d.depthFar>0&&(xe=d.depthFar)),W.near=I.near=L.near=me,W.far=I.far=L.far=xe,(N!==W.near||V!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),N=W.near,V=W.far),W.layers.mask=Q.layers.mask|6,L.layers.mask=W.layers.mask&-5,I.layers.mask=W.layers.mask&-3;let Ce=Q.parent,be=W.cameras;q(W,Ce);for(let We=0;We<be.length;We++)q(be[We],Ce);W.projectionMatrix.copy(L.projectionMatrix),W.projectionMatrixInverse.copy(L.projectionMatrixInverse),U===null&&Q.isPerspectiveCamera&&(U={camera:Q,fov:Q.fov,zoom:Q.zoom}),K(Q,W,Ce)};function K(Q,me,xe){xe===null?Q.matrix.copy(me.matrixWorld):(Q.matrix.copy(xe.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(me.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(me.projectionMatrix),Q.projectionMatrixInverse.copy(me.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Ic*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(h===null&&p===null))return l},this.setFoveation=function(Q){l=Q,h!==null&&(h.fixedFoveation=Q),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=Q)},this.hasDepthSensing=function(){return d.texture!==null},this.getDepthSensingMesh=function(){return d.getMesh(W)},this.getCameraTexture=function(Q){return m[Q]};let ne=null;function ue(Q,me){if(u=me.getViewerPose(c||o),g=me,u!==null){let xe=u.views;p!==null&&(e.setRenderTargetFramebuffer(S,p.framebuffer),e.setRenderTarget(S));let Ce=!1;xe.length!==W.cameras.length&&(W.cameras.length=0,Ce=!0);for(let Ve=0;Ve<xe.length;Ve++){let ft=xe[Ve],ct=null;if(p!==null)ct=p.getViewport(ft);else{let Kt=f.getViewSubImage(h,ft);ct=Kt.viewport,Ve===0&&(e.setRenderTargetTextures(S,Kt.colorTexture,Kt.depthStencilTexture),e.setRenderTarget(S))}let it=k[Ve];it===void 0&&(it=new ti,it.layers.enable(Ve),it.viewport=new Ht,k[Ve]=it),it.matrix.fromArray(ft.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(ft.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(ct.x,ct.y,ct.width,ct.height),Ve===0&&(W.matrix.copy(it.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Ce===!0&&W.cameras.push(it)}let be=s.enabledFeatures;if(be&&be.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){f=i.getBinding();let Ve=f.getDepthInformation(xe[0]);Ve&&Ve.isValid&&Ve.texture&&d.init(Ve,s.renderState)}if(be&&be.includes("camera-access")&&y){e.state.unbindTexture(),f=i.getBinding();for(let Ve=0;Ve<xe.length;Ve++){let ft=xe[Ve].camera;if(ft){let ct=m[ft];ct||(ct=new ka,m[ft]=ct);let it=f.getCameraImage(ft);ct.sourceTexture=it}}}}for(let xe=0;xe<C.length;xe++){let Ce=A[xe],be=C[xe];Ce!==null&&be!==void 0&&be.update(Ce,me,c||o)}ne&&ne(Q,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),g=null}let he=new n0;he.setAnimationLoop(ue),this.setAnimationLoop=function(Q){ne=Q},this.dispose=function(){}}},gA=new xt,f0=new tt;f0.set(-1,0,0,0,1,0,0,0,1);function _A(n,e){function t(d,m){d.matrixAutoUpdate===!0&&d.updateMatrix(),m.value.copy(d.matrix)}function i(d,m){m.color.getRGB(d.fogColor.value,Qf(n)),m.isFog?(d.fogNear.value=m.near,d.fogFar.value=m.far):m.isFogExp2&&(d.fogDensity.value=m.density)}function s(d,m,v,T,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(d,m):m.isMeshLambertMaterial?(r(d,m),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(d,m),f(d,m)):m.isMeshPhongMaterial?(r(d,m),u(d,m),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(d,m),h(d,m),m.isMeshPhysicalMaterial&&p(d,m,S)):m.isMeshMatcapMaterial?(r(d,m),g(d,m)):m.isMeshDepthMaterial?r(d,m):m.isMeshDistanceMaterial?(r(d,m),y(d,m)):m.isMeshNormalMaterial?r(d,m):m.isLineBasicMaterial?(o(d,m),m.isLineDashedMaterial&&a(d,m)):m.isPointsMaterial?l(d,m,v,T):m.isSpriteMaterial?c(d,m):m.isShadowMaterial?(d.color.value.copy(m.color),d.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(d,m){d.opacity.value=m.opacity,m.color&&d.diffuse.value.copy(m.color),m.emissive&&d.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(d.map.value=m.map,t(m.map,d.mapTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.bumpMap&&(d.bumpMap.value=m.bumpMap,t(m.bumpMap,d.bumpMapTransform),d.bumpScale.value=m.bumpScale,m.side===ii&&(d.bumpScale.value*=-1)),m.normalMap&&(d.normalMap.value=m.normalMap,t(m.normalMap,d.normalMapTransform),d.normalScale.value.copy(m.normalScale),m.side===ii&&d.normalScale.value.negate()),m.displacementMap&&(d.displacementMap.value=m.displacementMap,t(m.displacementMap,d.displacementMapTransform),d.displacementScale.value=m.displacementScale,d.displacementBias.value=m.displacementBias),m.emissiveMap&&(d.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,d.emissiveMapTransform)),m.specularMap&&(d.specularMap.value=m.specularMap,t(m.specularMap,d.specularMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest);let v=e.get(m),T=v.envMap,S=v.envMapRotation;T&&(d.envMap.value=T,d.envMapRotation.value.setFromMatrix4(gA.makeRotationFromEuler(S)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&d.envMapRotation.value.premultiply(f0),d.reflectivity.value=m.reflectivity,d.ior.value=m.ior,d.refractionRatio.value=m.refractionRatio),m.lightMap&&(d.lightMap.value=m.lightMap,d.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,d.lightMapTransform)),m.aoMap&&(d.aoMap.value=m.aoMap,d.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,d.aoMapTransform))}function o(d,m){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,m.map&&(d.map.value=m.map,t(m.map,d.mapTransform))}function a(d,m){d.dashSize.value=m.dashSize,d.totalSize.value=m.dashSize+m.gapSize,d.scale.value=m.scale}function l(d,m,v,T){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,d.size.value=m.size*v,d.scale.value=T*.5,m.map&&(d.map.value=m.map,t(m.map,d.uvTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest)}function c(d,m){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,d.rotation.value=m.rotation,m.map&&(d.map.value=m.map,t(m.map,d.mapTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest)}function u(d,m){d.specular.value.copy(m.specular),d.shininess.value=Math.max(m.shininess,1e-4)}function f(d,m){m.gradientMap&&(d.gradientMap.value=m.gradientMap)}function h(d,m){d.metalness.value=m.metalness,m.metalnessMap&&(d.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,d.metalnessMapTransform)),d.roughness.value=m.roughness,m.roughnessMap&&(d.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,d.roughnessMapTransform)),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)}function p(d,m,v){d.ior.value=m.ior,m.diffuseRoughness>0&&(d.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(d.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,d.diffuseRoughnessMapTransform))),m.sheen>0&&(d.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),d.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(d.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,d.sheenColorMapTransform)),m.sheenRoughnessMap&&(d.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,d.sheenRoughnessMapTransform))),m.clearcoat>0&&(d.clearcoat.value=m.clearcoat,d.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(d.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,d.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(d.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,d.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(d.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,d.clearcoatNormalMapTransform),d.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ii&&d.clearcoatNormalScale.value.negate())),m.dispersion>0&&(d.dispersion.value=m.dispersion),m.retroreflectivity>0&&(d.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(d.iridescence.value=m.iridescence,d.iridescenceIOR.value=m.iridescenceIOR,d.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,d.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(d.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,d.iridescenceMapTransform)),m.iridescenceThicknessMap&&(d.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,d.iridescenceThicknessMapTransform))),m.transmission>0&&(d.transmission.value=m.transmission,d.transmissionSamplerMap.value=v.texture,d.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(d.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,d.transmissionMapTransform)),d.thickness.value=m.thickness,m.thicknessMap&&(d.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,d.thicknessMapTransform)),d.attenuationDistance.value=m.attenuationDistance,d.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(d.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(d.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,d.anisotropyMapTransform))),d.specularIntensity.value=m.specularIntensity,d.specularColor.value.copy(m.specularColor),m.specularColorMap&&(d.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,d.specularColorMapTransform)),m.specularIntensityMap&&(d.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,d.specularIntensityMapTransform))}function g(d,m){m.matcap&&(d.matcap.value=m.matcap)}function y(d,m){let v=e.get(m).light;d.referencePosition.value.setFromMatrixPosition(v.matrixWorld),d.nearDistance.value=v.shadow.camera.near,d.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function xA(n,e,t,i){let s={},r={};function o(v,T){let S=T.program;i.uniformBlockBinding(v,S,s[v.id])}function a(v,T){let S=s[v.id];S===void 0&&(g(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",d));let C=T.program;i.updateUBOMapping(v,C);let A=e.render.frame;r[v.id]!==A&&(c(v),r[v.id]=A)}function l(v){let T=n.createBuffer(),S=v.__size,C=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,S,C),n.bindBuffer(n.UNIFORM_BUFFER,null),T}function c(v){let T=s[v.id],S=v.uniforms,C=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let A=0,_=S.length;A<_;A++){let w=S[A];if(Array.isArray(w))for(let U=0,L=w.length;U<L;U++)u(w[U],A,U,C);else u(w,A,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(v,T,S,C){if(h(v,T,S,C)===!0){let A=v.__offset,_=v.value;if(Array.isArray(_)){let w=0;for(let U=0;U<_.length;U++){let L=_[U],I=y(L,!0);f(L,v.__data,w),w+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else f(_,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,v.__data)}}function f(v,T,S){typeof v=="number"||typeof v=="boolean"?T[S]=v:v.isMatrix3?(T[S]=v.elements[0],T[S+1]=v.elements[1],T[S+2]=v.elements[2],T[S+3]=0,T[S+4]=v.elements[3],T[S+5]=v.elements[4],T[S+6]=v.elements[5],T[S+7]=0,T[S+8]=v.elements[6],T[S+9]=v.elements[7],T[S+10]=v.elements[8],T[S+11]=0):ArrayBuffer.isView(v)?T.set(v.subarray(0,T.length-S),S):v.toArray(T,S)}function h(v,T,S,C){let A=v.value,_=T+"_"+S;if(Array.isArray(A)){C[_]===void 0&&(C[_]=[]);let w=C[_],U=!1;for(let L=0;L<A.length;L++)p(A[L],w,L)===!0&&(U=!0);return U}return p(A,C,_)}function p(v,T,S){if(T[S]===void 0)return typeof v=="number"||typeof v=="boolean"?T[S]=v:ArrayBuffer.isView(v)?T[S]=v.slice():T[S]=v.clone(),!0;{let C=T[S];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return T[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function g(v){let T=v.uniforms,S=0,C=16;for(let _=0,w=T.length;_<w;_++){let U=Array.isArray(T[_])?T[_]:[T[_]];for(let L=0,I=U.length;L<I;L++){let k=U[L],W=Array.isArray(k.value)?k.value:[k.value],N=Array.isArray(T[_])||Array.isArray(k.value),V=S;for(let G=0,ae=W.length;G<ae;G++){let q=W[G],K=y(q,N),ne=S%C,ue=ne%K.boundary,he=ne+ue;S+=ue,he!==0&&C-he<K.storage&&(S+=C-he),G===0&&(V=S),S+=K.storage}let Y=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new Y((S-V)/Float32Array.BYTES_PER_ELEMENT),k.__offset=V}}let A=S%C;return A>0&&(S+=C-A),v.__size=S,v.__cache={},this}function y(v,T){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Ze("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Ze("WebGLRenderer: Unsupported uniform value type.",v),T===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function d(v){let T=v.target;T.removeEventListener("dispose",d),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function m(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var vA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ms=null;function yA(){return ms===null&&(ms=new Cr(vA,16,16,ji,Ji),ms.name="DFG_LUT",ms.minFilter=ni,ms.magFilter=ni,ms.wrapS=hs,ms.wrapT=hs,ms.generateMipmaps=!1,ms.needsUpdate=!0),ms}var Hu=class{constructor(e={}){let{canvas:t=Ag(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:p=Xn}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let y=p,d=new Set([cu,lu,au]),m=new Set([Xn,Zi,zo,Dr,ru,ou]),v=new Uint32Array(4),T=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,A=null,_=[],w=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ps,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,I=!1,k=null,W=null,N=null,V=null;this._outputColorSpace=ei;let Y=0,G=0,ae=null,q=-1,K=null,ne=new Ht,ue=new Ht,he=null,Q=new qe(0),me=0,xe=t.width,Ce=t.height,be=1,We=null,rt=null,Ve=new Ht(0,0,xe,Ce),ft=new Ht(0,0,xe,Ce),ct=!1,it=new sr,Kt=new Uc,Vt=!1,xn=!1,Ut=new xt,Nn=new B,St=new Ht,Tn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},sn=!1;function vn(){return ae===null?be:1}let O=i;function Pe(E,z){return t.getContext(E,z)}let $e,ot,we,Ot,Ge,Ye,R,M,X,ce,re,_e,ve,ee,ie,pe,F,se,te,Ee,ge,Se,He;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",Ke,!1),t.addEventListener("webglcontextcreationerror",Re,!1),O===null){let z="webgl2";if(O=Pe(z,E),O===null)throw Pe(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}je()}catch(E){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),Qe("WebGLRenderer: "+E.message),E}function je(){$e=new I1(O),$e.init(),ge=new dA(O,$e),ot=new y1(O,$e,e,ge),we=new hA(O,$e),ot.reversedDepthBuffer&&h&&we.buffers.depth.setReversed(!0),W=O.createFramebuffer(),N=O.createFramebuffer(),V=O.createFramebuffer(),Ot=new D1(O),Ge=new jE,Ye=new fA(O,$e,we,Ge,ot,ge,Ot),R=new P1(L),M=new FM(O),Se=new x1(O,M),X=new L1(O,M,Ot,Se),ce=new F1(O,X,M,Se,Ot),se=new U1(O,ot,Ye),ie=new S1(Ge),re=new JE(L,R,$e,ot,Se,ie),_e=new _A(L,Ge),ve=new QE,ee=new rA($e),F=new _1(L,R,we,ce,g,l),pe=new uA(L,ce,ot),He=new xA(O,Ot,ot,we),te=new v1(O,$e,Ot),Ee=new N1(O,$e,Ot),Ot.programs=re.programs,L.capabilities=ot,L.extensions=$e,L.properties=Ge,L.renderLists=ve,L.shadowMap=pe,L.state=we,L.info=Ot}y!==Xn&&(U=new B1(y,t.width,t.height,a,s,r));let le=new fd(L,O);this.xr=le,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let E=$e.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=$e.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return be},this.setPixelRatio=function(E){E!==void 0&&(be=E,this.setSize(xe,Ce,!1))},this.getSize=function(E){return E.set(xe,Ce)},this.setSize=function(E,z,j=!0){if(le.isPresenting){Ze("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=E,Ce=z,t.width=Math.floor(E*be),t.height=Math.floor(z*be),j===!0&&(t.style.width=E+"px",t.style.height=z+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,E,z)},this.getDrawingBufferSize=function(E){return E.set(xe*be,Ce*be).floor()},this.setDrawingBufferSize=function(E,z,j){xe=E,Ce=z,be=j,t.width=Math.floor(E*j),t.height=Math.floor(z*j),this.setViewport(0,0,E,z)},this.setEffects=function(E){if(y===Xn){Qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let z=0;z<E.length;z++)if(E[z].isOutputPass===!0){Ze("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(ne)},this.getViewport=function(E){return E.copy(Ve)},this.setViewport=function(E,z,j,$){E.isVector4?Ve.set(E.x,E.y,E.z,E.w):Ve.set(E,z,j,$),we.viewport(ne.copy(Ve).multiplyScalar(vn()).round())},this.getScissor=function(E){return E.copy(ft)},this.setScissor=function(E,z,j,$){E.isVector4?ft.set(E.x,E.y,E.z,E.w):ft.set(E,z,j,$),we.scissor(ue.copy(ft).multiplyScalar(vn()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(E){we.setScissorTest(ct=E)},this.setOpaqueSort=function(E){We=E},this.setTransparentSort=function(E){rt=E},this.getClearColor=function(E){return E.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(E=!0,z=!0,j=!0){let $=0;if(E){let Z=!1;if(ae!==null){let Ae=ae.texture.format;Z=d.has(Ae)}if(Z){let Ae=ae.texture.type,Ie=m.has(Ae),Te=F.getClearColor(),Le=F.getClearAlpha(),ze=Te.r,et=Te.g,dt=Te.b;Ie?(v[0]=ze,v[1]=et,v[2]=dt,v[3]=Le,O.clearBufferuiv(O.COLOR,0,v)):(T[0]=ze,T[1]=et,T[2]=dt,T[3]=Le,O.clearBufferiv(O.COLOR,0,T))}else $|=O.COLOR_BUFFER_BIT}z&&($|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&O.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),k=E},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),F.dispose(),ve.dispose(),ee.dispose(),Ye.dispose(),Ge.dispose(),R.dispose(),ce.dispose(),X.dispose(),Se.dispose(),He.dispose(),re.dispose(),le.dispose(),le.removeEventListener("sessionstart",ql),le.removeEventListener("sessionend",is),ys.stop()};function Be(E){E.preventDefault(),jf("WebGLRenderer: Context Lost."),I=!0}function Ke(){jf("WebGLRenderer: Context Restored."),I=!1;let E=Ot.autoReset,z=pe.enabled,j=pe.autoUpdate,$=pe.needsUpdate,Z=pe.type;je(),Ot.autoReset=E,pe.enabled=z,pe.autoUpdate=j,pe.needsUpdate=$,pe.type=Z}function Re(E){Qe("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function at(E){let z=E.target;z.removeEventListener("dispose",at),qt(z)}function qt(E){Zn(E),Ge.remove(E)}function Zn(E){let z=Ge.get(E).programs;z!==void 0&&(z.forEach(function(j){re.releaseProgram(j)}),E.isShaderMaterial&&re.releaseShaderCache(E))}this.renderBufferDirect=function(E,z,j,$,Z,Ae){z===null&&(z=Tn);let Ie=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Te=da(E,z,j,$,Z);we.setMaterial($,Ie);let Le=j.index,ze=1;if($.wireframe===!0){if(Le=X.getWireframeAttribute(j),Le===void 0)return;ze=2}let et=j.drawRange,dt=j.attributes.position,ke=et.start*ze,pt=(et.start+et.count)*ze;Ae!==null&&(ke=Math.max(ke,Ae.start*ze),pt=Math.min(pt,(Ae.start+Ae.count)*ze)),Le!==null?(ke=Math.max(ke,0),pt=Math.min(pt,Le.count)):dt!=null&&(ke=Math.max(ke,0),pt=Math.min(pt,dt.count));let nn=pt-ke;if(nn<0||nn===1/0)return;Se.setup(Z,$,Te,j,Le);let It,Lt=te;if(Le!==null&&(It=M.get(Le),Lt=Ee,Lt.setIndex(It)),Z.isMesh)$.wireframe===!0?(we.setLineWidth($.wireframeLinewidth*vn()),Lt.setMode(O.LINES)):Lt.setMode(O.TRIANGLES);else if(Z.isLine){let Cn=$.linewidth;Cn===void 0&&(Cn=1),we.setLineWidth(Cn*vn()),Z.isLineSegments?Lt.setMode(O.LINES):Z.isLineLoop?Lt.setMode(O.LINE_LOOP):Lt.setMode(O.LINE_STRIP)}else Z.isPoints?Lt.setMode(O.POINTS):Z.isSprite&&Lt.setMode(O.TRIANGLES);if(Z.isBatchedMesh)if($e.get("WEBGL_multi_draw"))Lt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let Cn=Z._multiDrawStarts,Fe=Z._multiDrawCounts,yn=Z._multiDrawCount,gt=Le?M.get(Le).bytesPerElement:1,Ms=Ge.get($).currentProgram.getUniforms();for(let Sn=0;Sn<yn;Sn++)Ms.setValue(O,"_gl_DrawID",Sn),Lt.render(Cn[Sn]/gt,Fe[Sn])}else if(Z.isInstancedMesh)Lt.renderInstances(ke,nn,Z.count);else if(j.isInstancedBufferGeometry){let Cn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Fe=Math.min(j.instanceCount,Cn);Lt.renderInstances(ke,nn,Fe)}else Lt.render(ke,nn)};function ua(E,z,j,$){k!==null&&E.isNodeMaterial&&k.setObject($,E),Vt===!0&&ie.setState(E,j,!1),E.transparent===!0&&E.side===Ii&&E.forceSinglePass===!1?(E.side=ii,E.needsUpdate=!0,ss(E,z,$),E.side=ur,E.needsUpdate=!0,ss(E,z,$),E.side=Ii):ss(E,z,$)}this.compile=function(E,z,j=null){j===null&&(j=E),k!==null&&k.renderStart(E,z,j),A=ee.get(j),A.init(z),w.push(A),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),E!==j&&E.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),A.setupLights(),k!==null&&k.updateLights(A.state.lightsArray),xn=this.localClippingEnabled,Vt=ie.init(this.clippingPlanes,xn),Vt===!0&&ie.setGlobalState(this.clippingPlanes,z),k!==null&&pe.render(A.state.shadowsArray,j,z);let $=new Set;return E.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Ae=Z.material;if(Ae)if(Array.isArray(Ae))for(let Ie=0;Ie<Ae.length;Ie++){let Te=Ae[Ie];ua(Te,j,z,Z),$.add(Te)}else ua(Ae,j,z,Z),$.add(Ae)}),A=w.pop(),k!==null&&k.renderEnd(),$},this.compileAsync=function(E,z,j=null){let $=this.compile(E,z,j);return new Promise(Z=>{function Ae(){if($.forEach(function(Ie){let Le=Ge.get(Ie).currentProgram;(Le===void 0||Le.isReady())&&$.delete(Ie)}),$.size===0){Z(E);return}setTimeout(Ae,10)}$e.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let eo=null;function zh(E){eo&&eo(E)}function ql(){ys.stop()}function is(){ys.start()}let ys=new n0;ys.setAnimationLoop(zh),typeof self<"u"&&ys.setContext(self),this.setAnimationLoop=function(E){eo=E,le.setAnimationLoop(E),E===null?ys.stop():ys.start()},le.addEventListener("sessionstart",ql),le.addEventListener("sessionend",is),this.render=function(E,z){if(z!==void 0&&z.isCamera!==!0){Qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;k!==null&&k.renderStart(E,z);let j=le.enabled===!0&&le.isPresenting===!0,$=U!==null&&(ae===null||j)&&U.begin(L,ae);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(z),z=le.getCamera()),E.isScene===!0&&E.onBeforeRender(L,E,z,ae),A=ee.get(E,w.length),A.init(z),A.state.textureUnits=Ye.getTextureUnits(),w.push(A),Ut.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Kt.setFromArrayCamera(z):it.setFromProjectionMatrix(Ut,Ri,z.reversedDepth),xn=this.localClippingEnabled,Vt=ie.init(this.clippingPlanes,xn),C=ve.get(E,_.length),C.init(),_.push(C),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let Ie=L.xr.getDepthSensingMesh();Ie!==null&&Ss(Ie,z,-1/0,L.sortObjects)}Ss(E,z,0,L.sortObjects),C.finish(),k!==null&&k.updateLights(A.state.lightsArray),L.sortObjects===!0&&C.sort(We,rt),sn=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,sn&&F.addToRenderList(C,E),this.info.autoReset===!0&&this.info.reset(),Vt===!0&&ie.beginShadows();let Z=A.state.shadowsArray;if(pe.render(Z,E,z),Vt===!0&&ie.endShadows(),($&&U.hasRenderPass())===!1){let Ie=C.opaque,Te=C.transmissive;if(A.setupLights(),z.isArrayCamera){let Le=z.cameras;if(Te.length>0)for(let ze=0,et=Le.length;ze<et;ze++){let dt=Le[ze];Bi(Ie,Te,E,dt)}sn&&F.render(E);for(let ze=0,et=Le.length;ze<et;ze++){let dt=Le[ze];ha(C,E,dt,dt.viewport)}}else Te.length>0&&Bi(Ie,Te,E,z),sn&&F.render(E),ha(C,E,z)}ae!==null&&G===0&&(Ye.updateMultisampleRenderTarget(ae),Ye.updateRenderTargetMipmap(ae)),$&&U.end(L),E.isScene===!0&&E.onAfterRender(L,E,z),Se.resetDefaultState(),q=-1,K=null,w.pop(),w.length>0?(A=w[w.length-1],Ye.setTextureUnits(A.state.textureUnits),Vt===!0&&ie.setGlobalState(L.clippingPlanes,A.state.camera)):A=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,k!==null&&k.renderEnd()};function Ss(E,z,j,$){if(E.visible===!1)return;if(E.layers.test(z.layers)){if(E.isGroup)j=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(z);else if(E.isLight)A.pushLight(E),E.castShadow&&A.pushShadow(E);else if(E.isSprite){let Ie=z.isArrayCamera?Kt:it;if(!E.frustumCulled||E.intersectsFrustum(Ie)){$&&St.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Ut);let Te=ce.update(E),Le=E.material;Le.visible&&C.push(E,Te,Le,j,St.z,null,z)}}else if(E.isMesh||E.isLine||E.isPoints){let Ie=z.isArrayCamera?Kt:it;if(!E.frustumCulled||E.intersectsFrustum(Ie)){let Te=ce.update(E),Le=E.material;if($&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),St.copy(E.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),St.copy(Te.boundingSphere.center)),St.applyMatrix4(E.matrixWorld).applyMatrix4(Ut)),Array.isArray(Le)){let ze=Te.groups;for(let et=0,dt=ze.length;et<dt;et++){let ke=ze[et],pt=Le[ke.materialIndex];pt&&pt.visible&&C.push(E,Te,pt,j,St.z,ke,z)}}else Le.visible&&C.push(E,Te,Le,j,St.z,null,z)}}}let Ae=E.children;for(let Ie=0,Te=Ae.length;Ie<Te;Ie++)Ss(Ae[Ie],z,j,$)}function ha(E,z,j,$){let{opaque:Z,transmissive:Ae,transparent:Ie}=E;A.setupLightsView(j),Vt===!0&&ie.setGlobalState(L.clippingPlanes,j),$&&we.viewport(ne.copy($)),Z.length>0&&rn(Z,z,j),Ae.length>0&&rn(Ae,z,j),Ie.length>0&&rn(Ie,z,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Bi(E,z,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[$.id]===void 0){let ke=$e.has("EXT_color_buffer_half_float")||$e.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[$.id]=new vi(1,1,{generateMipmaps:!0,type:ke?Ji:Xn,minFilter:Fs,samples:Math.max(4,ot.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:_t.workingColorSpace})}let Ae=A.state.transmissionRenderTarget[$.id],Ie=$.viewport||ne;Ae.setSize(Ie.z*L.transmissionResolutionScale,Ie.w*L.transmissionResolutionScale);let Te=L.getRenderTarget(),Le=L.getActiveCubeFace(),ze=L.getActiveMipmapLevel();L.setRenderTarget(Ae),L.getClearColor(Q),me=L.getClearAlpha(),me<1&&L.setClearColor(16777215,.5),L.clear(),sn&&F.render(j);let et=L.toneMapping;L.toneMapping=ps;let dt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),A.setupLightsView($),Vt===!0&&ie.setGlobalState(L.clippingPlanes,$),rn(E,j,$),Ye.updateMultisampleRenderTarget(Ae),Ye.updateRenderTargetMipmap(Ae),$e.has("WEBGL_multisampled_render_to_texture")===!1){let ke=!1;for(let pt=0,nn=z.length;pt<nn;pt++){let It=z[pt],{object:Lt,geometry:Cn,material:Fe,group:yn}=It;if(Fe.side===Ii&&Lt.layers.test($.layers)){let gt=Fe.side;Fe.side=ii,Fe.needsUpdate=!0,dn(Lt,j,$,Cn,Fe,yn),Fe.side=gt,Fe.needsUpdate=!0,ke=!0}}ke===!0&&(Ye.updateMultisampleRenderTarget(Ae),Ye.updateRenderTargetMipmap(Ae))}L.setRenderTarget(Te,Le,ze),L.setClearColor(Q,me),dt!==void 0&&($.viewport=dt),L.toneMapping=et}function rn(E,z,j){let $=z.isScene===!0?z.overrideMaterial:null;for(let Z=0,Ae=E.length;Z<Ae;Z++){let Ie=E[Z],{object:Te,geometry:Le,group:ze}=Ie,et=Ie.material;et.allowOverride===!0&&$!==null&&(et=$),Te.layers.test(j.layers)&&dn(Te,z,j,Le,et,ze)}}function dn(E,z,j,$,Z,Ae){k!==null&&Z.isNodeMaterial&&k.setObject(E,Z),E.onBeforeRender(L,z,j,$,Z,Ae),E.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),Z.onBeforeRender(L,z,j,$,E,Ae),Z.transparent===!0&&Z.side===Ii&&Z.forceSinglePass===!1?(Z.side=ii,Z.needsUpdate=!0,L.renderBufferDirect(j,z,$,Z,E,Ae),Z.side=ur,Z.needsUpdate=!0,L.renderBufferDirect(j,z,$,Z,E,Ae),Z.side=Ii):L.renderBufferDirect(j,z,$,Z,E,Ae),E.onAfterRender(L,z,j,$,Z,Ae)}function pn(E){let z=0;for(let j of E)j.texture!==null&&z++;return z}function ss(E,z,j){z.isScene!==!0&&(z=Tn);let $=Ge.get(E),Z=A.state.lights,Ae=A.state.shadowsArray,Ie=Z.state.version,Te=re.getParameters(E,Z.state,Ae,z,j,A.state.lightProbeGridArray),Le=re.getProgramCacheKey(Te),ze=$.programs;$.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?z.environment:null,$.fog=z.fog;let et=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;$.envMap=R.get(E.envMap||$.environment,et),$.envMapRotation=$.environment!==null&&E.envMap===null?z.environmentRotation:E.envMapRotation,ze===void 0&&(E.addEventListener("dispose",at),ze=new Map,$.programs=ze,$.programVariants=new Map);let dt=ze.get(Le);if(dt!==void 0){if($.currentProgram===dt&&$.lightsStateVersion===Ie)return fa(E,Te),dt}else Te.uniforms=re.getUniforms(E),k!==null&&E.isNodeMaterial&&k.build(E,j,Te),E.onBeforeCompile(Te,L),dt=re.acquireProgram(Te,Le),ze.set(Le,dt),$.uniforms=Te.uniforms;let ke=$.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(ke.clippingPlanes=ie.uniform),fa(E,Te),$.needsLights=Ys(E),$.lightsStateVersion=Ie,$.needsLights&&(ke.ambientLightColor.value=Z.state.ambient,ke.lightProbe.value=Z.state.probe,ke.sunLights.value=Z.state.sun,ke.sunLightShadows.value=Z.state.sunShadow,ke.directionalLights.value=Z.state.directional,ke.directionalLightShadows.value=Z.state.directionalShadow,ke.spotLights.value=Z.state.spot,ke.spotLightShadows.value=Z.state.spotShadow,ke.rectAreaLights.value=Z.state.rectArea,ke.ltc_1.value=Z.state.rectAreaLTC1,ke.ltc_2.value=Z.state.rectAreaLTC2,ke.pointLights.value=Z.state.point,ke.pointLightShadows.value=Z.state.pointShadow,ke.hemisphereLights.value=Z.state.hemi,ke.sunShadowMatrix.value=Z.state.sunShadowMatrix,ke.sunShadowCascade.value=Z.state.sunShadowCascade,ke.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,ke.spotLightMatrix.value=Z.state.spotLightMatrix,ke.spotLightMap.value=Z.state.spotLightMap,ke.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=pn(A.state.lightProbeGridArray),$.currentProgram=dt,$.uniformsList=null,dt}function di(E,z,j,$,Z){let Ae=Ge.get(E),Ie=Ae.currentProgram.id+","+$+","+Z,Te=Ae.programVariants.get(Ie);return Te===void 0?(Te=ss(E,z,j),Ae.programVariants.set(Ie,Te)):(Ae.currentProgram=Te,Ae.uniformsList=null,Ae.outputColorSpace=$,Ae.toneMapping=Z),Te}function qs(E){if(E.uniformsList===null){let z=E.currentProgram.getUniforms();E.uniformsList=Vo.seqWithValue(z.seq,E.uniforms)}return E.uniformsList}function fa(E,z){let j=Ge.get(E);j.outputColorSpace=z.outputColorSpace,j.batching=z.batching,j.batchingColor=z.batchingColor,j.instancing=z.instancing,j.instancingColor=z.instancingColor,j.instancingMorph=z.instancingMorph,j.skinning=z.skinning,j.morphTargets=z.morphTargets,j.morphNormals=z.morphNormals,j.morphColors=z.morphColors,j.morphTargetsCount=z.morphTargetsCount,j.numClippingPlanes=z.numClippingPlanes,j.numIntersection=z.numClipIntersection,j.vertexAlphas=z.vertexAlphas,j.vertexTangents=z.vertexTangents,j.toneMapping=z.toneMapping}function da(E,z,j,$,Z){z.isScene!==!0&&(z=Tn),Ye.resetTextureUnits();let Ae=z.fog,Ie=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?z.environment:null,Te=ae===null?L.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:_t.workingColorSpace,Le=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,ze=R.get($.envMap||Ie,Le),et=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,dt=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),ke=!!j.morphAttributes.position,pt=!!j.morphAttributes.normal,nn=!!j.morphAttributes.color,It=ps;$.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(It=L.toneMapping);let Lt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Cn=Lt!==void 0?Lt.length:0,Fe=Ge.get($),yn=A.state.lights;if(Vt===!0&&(xn===!0||E!==K)){let Nt=E===K&&$.id===q;ie.setState($,E,Nt)}let gt=!1,Ms=!1;$.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==yn.state.version||Z.isBatchedMesh&&Fe.batching===!1||!Z.isBatchedMesh&&Fe.batching===!0||Z.isBatchedMesh&&Fe.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Fe.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Fe.instancing===!1||!Z.isInstancedMesh&&Fe.instancing===!0||Z.isSkinnedMesh&&Fe.skinning===!1||!Z.isSkinnedMesh&&Fe.skinning===!0||Z.isInstancedMesh&&Fe.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Fe.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Fe.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Fe.instancingMorph===!1&&Z.morphTexture!==null||Fe.envMap!==ze||$.fog===!0&&Fe.fog!==Ae||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==ie.numPlanes||Fe.numIntersection!==ie.numIntersection)||Fe.vertexAlphas!==et||Fe.vertexTangents!==dt||Fe.morphTargets!==ke||Fe.morphNormals!==pt||Fe.morphColors!==nn||Fe.morphTargetsCount!==Cn||Fe.numLightProbeGrids!==pn(A.state.lightProbeGridArray)?gt=!0:(Fe.outputColorSpace!==Te||Fe.toneMapping!==It)&&(Ms=!0):(gt=!0,Fe.__version=$.version);let Sn=Fe.currentProgram;(gt===!0||Ms===!0)&&(Sn=Ms===!0?di($,z,Z,Te,It):ss($,z,Z),k&&$.isNodeMaterial&&k.onUpdateProgram($,Sn,Fe));let io=!1,rs=!1,bs=!1,ut=Sn.getUniforms(),on=Fe.uniforms;if(we.useProgram(Sn.program)&&(io=!0,rs=!0,bs=!0),$.id!==q&&(q=$.id,rs=!0),io||K!==E){we.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),ut.setValue(O,"projectionMatrix",E.projectionMatrix),ut.setValue(O,"viewMatrix",E.matrixWorldInverse);let Mn=ut.map.cameraPosition;Mn!==void 0&&Mn.setValue(O,Nn.setFromMatrixPosition(E.matrixWorld)),ot.logarithmicDepthBuffer&&ut.setValue(O,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&ut.setValue(O,"isOrthographic",E.isOrthographicCamera===!0),K!==E&&(K=E,rs=!0,bs=!0)}if(Fe.needsLights&&(yn.state.sunShadowMap.length>0&&ut.setValue(O,"sunShadowMap",yn.state.sunShadowMap,Ye),yn.state.directionalShadowMap.length>0&&ut.setValue(O,"directionalShadowMap",yn.state.directionalShadowMap,Ye),yn.state.spotShadowMap.length>0&&ut.setValue(O,"spotShadowMap",yn.state.spotShadowMap,Ye),yn.state.pointShadowMap.length>0&&ut.setValue(O,"pointShadowMap",yn.state.pointShadowMap,Ye)),Z.isSkinnedMesh){ut.setOptional(O,Z,"bindMatrix"),ut.setOptional(O,Z,"bindMatrixInverse");let Nt=Z.skeleton;Nt&&(Nt.boneTexture===null&&Nt.computeBoneTexture(),ut.setValue(O,"boneTexture",Nt.boneTexture,Ye))}Z.isBatchedMesh&&(ut.setOptional(O,Z,"batchingTexture"),ut.setValue(O,"batchingTexture",Z._matricesTexture,Ye),ut.setOptional(O,Z,"batchingIdTexture"),ut.setValue(O,"batchingIdTexture",Z._indirectTexture,Ye),ut.setOptional(O,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ut.setValue(O,"batchingColorTexture",Z._colorsTexture,Ye));let Jn=j.morphAttributes;if((Jn.position!==void 0||Jn.normal!==void 0||Jn.color!==void 0)&&se.update(Z,j,Sn),(rs||Fe.receiveShadow!==Z.receiveShadow)&&(Fe.receiveShadow=Z.receiveShadow,ut.setValue(O,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&z.environment!==null&&(on.envMapIntensity.value=z.environmentIntensity),on.dfgLUT!==void 0&&(on.dfgLUT.value=yA()),rs){if(ut.setValue(O,"toneMappingExposure",L.toneMappingExposure),Fe.needsLights&&to(on,bs),Ae&&$.fog===!0&&_e.refreshFogUniforms(on,Ae),_e.refreshMaterialUniforms(on,$,be,Ce,A.state.transmissionRenderTarget[E.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Nt=S,Mn=0;for(let Vn of A.state.lightProbeGridArray)Vn.texture!==null&&(Nt.textures[Mn]=Vn.texture,Nt.min[Mn]=Vn.boundingBox.min,Nt.max[Mn]=Vn.boundingBox.max,Nt.resolution[Mn]=Vn.resolution,Mn++);for(let Vn in Nt)Nt[Vn].length=Mn;on.probesSH.value=Nt.textures,on.probesMin.value=Nt.min,on.probesMax.value=Nt.max,on.probesResolution.value=Nt.resolution}Vo.upload(O,qs(Fe),on,Ye)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Vo.upload(O,qs(Fe),on,Ye),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&ut.setValue(O,"center",Z.center),ut.setValue(O,"modelViewMatrix",Z.modelViewMatrix),ut.setValue(O,"normalMatrix",Z.normalMatrix),ut.setValue(O,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let Nt=$.uniformsGroups;for(let Mn=0,Vn=Nt.length;Mn<Vn;Mn++){let Yl=Nt[Mn];He.update(Yl,Sn),He.bind(Yl,Sn)}}return Sn}function to(E,z){E.ambientLightColor.needsUpdate=z,E.lightProbe.needsUpdate=z,E.sunLights.needsUpdate=z,E.sunLightShadows.needsUpdate=z,E.directionalLights.needsUpdate=z,E.directionalLightShadows.needsUpdate=z,E.pointLights.needsUpdate=z,E.pointLightShadows.needsUpdate=z,E.spotLights.needsUpdate=z,E.spotLightShadows.needsUpdate=z,E.rectAreaLights.needsUpdate=z,E.hemisphereLights.needsUpdate=z}function Ys(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ae},this.setRenderTargetTextures=function(E,z,j){let $=Ge.get(E);$.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Ge.get(E.texture).__webglTexture=z,Ge.get(E.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,z){let j=Ge.get(E);j.__webglFramebuffer=z,j.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(E,z=0,j=0){ae=E,Y=z,G=j;let $=null,Z=!1,Ae=!1;if(E){let Te=Ge.get(E);if(Te.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(O.FRAMEBUFFER,Te.__webglFramebuffer),ne.copy(E.viewport),ue.copy(E.scissor),he=E.scissorTest,we.viewport(ne),we.scissor(ue),we.setScissorTest(he),q=-1;return}else if(Te.__webglFramebuffer===void 0)Ye.setupRenderTarget(E);else if(Te.__hasExternalTextures)Ye.rebindTextures(E,Ge.get(E.texture).__webglTexture,Ge.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let et=E.depthTexture;if(Te.__boundDepthTexture!==et){if(et!==null&&Ge.has(et)&&(E.width!==et.image.width||E.height!==et.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ye.setupDepthRenderbuffer(E)}}let Le=E.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(Ae=!0);let ze=Ge.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(ze[z])?$=ze[z][j]:$=ze[z],Z=!0):E.samples>0&&Ye.useMultisampledRTT(E)===!1?$=Ge.get(E).__webglMultisampledFramebuffer:Array.isArray(ze)?$=ze[j]:$=ze,ne.copy(E.viewport),ue.copy(E.scissor),he=E.scissorTest}else ne.copy(Ve).multiplyScalar(be).floor(),ue.copy(ft).multiplyScalar(be).floor(),he=ct;if(j!==0&&($=W),we.bindFramebuffer(O.FRAMEBUFFER,$)&&we.drawBuffers(E,$),we.viewport(ne),we.scissor(ue),we.setScissorTest(he),Z){let Te=Ge.get(E.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+z,Te.__webglTexture,j)}else if(Ae){let Te=z;for(let Le=0;Le<E.textures.length;Le++){let ze=Ge.get(E.textures[Le]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Le,ze.__webglTexture,j,Te)}}else if(E!==null&&j!==0){let Te=Ge.get(E.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Te.__webglTexture,j)}q=-1};function no(E){let z=Ge.get(E);return(z.__readFormat!==E.format||z.__readType!==E.type)&&(z.__readFormat=E.format,z.__readType=E.type,z.__formatReadable=ot.textureFormatReadable(E.format),z.__typeReadable=ot.textureTypeReadable(E.type)),z}this.readRenderTargetPixels=function(E,z,j,$,Z,Ae,Ie,Te=0){if(!(E&&E.isWebGLRenderTarget)){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=Ge.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le){we.bindFramebuffer(O.FRAMEBUFFER,Le);try{let ze=E.textures[Te],et=ze.format,dt=ze.type;E.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Te);let ke=no(ze);if(ke.__formatReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ke.__typeReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=E.width-$&&j>=0&&j<=E.height-Z&&O.readPixels(z,j,$,Z,ge.convert(et),ge.convert(dt),Ae)}finally{let ze=ae!==null?Ge.get(ae).__webglFramebuffer:null;we.bindFramebuffer(O.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(E,z,j,$,Z,Ae,Ie,Te=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=Ge.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le)if(z>=0&&z<=E.width-$&&j>=0&&j<=E.height-Z){we.bindFramebuffer(O.FRAMEBUFFER,Le);let ze=E.textures[Te],et=ze.format,dt=ze.type;E.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Te);let ke=no(ze);if(ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.bufferData(O.PIXEL_PACK_BUFFER,Ae.byteLength,O.STREAM_READ),O.readPixels(z,j,$,Z,ge.convert(et),ge.convert(dt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let nn=ae!==null?Ge.get(ae).__webglFramebuffer:null;we.bindFramebuffer(O.FRAMEBUFFER,nn);let It=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await Cg(O,It,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Ae),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(pt),O.deleteSync(It),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,z=null,j=0){let $=Math.pow(2,-j),Z=Math.floor(E.image.width*$),Ae=Math.floor(E.image.height*$),Ie=z!==null?z.x:0,Te=z!==null?z.y:0;Ye.setTexture2D(E,0),O.copyTexSubImage2D(O.TEXTURE_2D,j,0,0,Ie,Te,Z,Ae),we.unbindTexture()},this.copyTextureToTexture=function(E,z,j=null,$=null,Z=0,Ae=0){let Ie,Te,Le,ze,et,dt,ke,pt,nn,It=E.isCompressedTexture?E.mipmaps[Ae]:E.image;if(j!==null)Ie=j.max.x-j.min.x,Te=j.max.y-j.min.y,Le=j.isBox3?j.max.z-j.min.z:1,ze=j.min.x,et=j.min.y,dt=j.isBox3?j.min.z:0;else{let ut=Math.pow(2,-Z);Ie=Math.floor(It.width*ut),Te=Math.floor(It.height*ut),E.isDataArrayTexture?Le=It.depth:E.isData3DTexture?Le=Math.floor(It.depth*ut):Le=1,ze=0,et=0,dt=0}$!==null?(ke=$.x,pt=$.y,nn=$.z):(ke=0,pt=0,nn=0);let Lt=ge.convert(z.format),Cn=ge.convert(z.type),Fe;z.isData3DTexture?(Ye.setTexture3D(z,0),Fe=O.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Ye.setTexture2DArray(z,0),Fe=O.TEXTURE_2D_ARRAY):(Ye.setTexture2D(z,0),Fe=O.TEXTURE_2D),we.activeTexture(O.TEXTURE0),we.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,z.flipY),we.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),we.pixelStorei(O.UNPACK_ALIGNMENT,z.unpackAlignment);let yn=we.getParameter(O.UNPACK_ROW_LENGTH),gt=we.getParameter(O.UNPACK_IMAGE_HEIGHT),Ms=we.getParameter(O.UNPACK_SKIP_PIXELS),Sn=we.getParameter(O.UNPACK_SKIP_ROWS),io=we.getParameter(O.UNPACK_SKIP_IMAGES);we.pixelStorei(O.UNPACK_ROW_LENGTH,It.width),we.pixelStorei(O.UNPACK_IMAGE_HEIGHT,It.height),we.pixelStorei(O.UNPACK_SKIP_PIXELS,ze),we.pixelStorei(O.UNPACK_SKIP_ROWS,et),we.pixelStorei(O.UNPACK_SKIP_IMAGES,dt);let rs=E.isDataArrayTexture||E.isData3DTexture,bs=z.isDataArrayTexture||z.isData3DTexture;if(E.isDepthTexture){let ut=Ge.get(E),on=Ge.get(z),Jn=Ge.get(ut.__renderTarget),Nt=Ge.get(on.__renderTarget);we.bindFramebuffer(O.READ_FRAMEBUFFER,Jn.__webglFramebuffer),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let Mn=0;Mn<Le;Mn++)rs&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ge.get(E).__webglTexture,Z,dt+Mn),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ge.get(z).__webglTexture,Ae,nn+Mn)),O.blitFramebuffer(ze,et,ze+Ie,et+Te,ke,pt,ke+Ie,pt+Te,O.DEPTH_BUFFER_BIT,O.NEAREST);we.bindFramebuffer(O.READ_FRAMEBUFFER,null),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(Z!==0||E.isRenderTargetTexture||Ge.has(E)){let ut=Ge.get(E),on=Ge.get(z);we.bindFramebuffer(O.READ_FRAMEBUFFER,N),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,V);for(let Jn=0;Jn<Le;Jn++)rs?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ut.__webglTexture,Z,dt+Jn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ut.__webglTexture,Z),bs?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,on.__webglTexture,Ae,nn+Jn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,on.__webglTexture,Ae),Z!==0?O.blitFramebuffer(ze,et,ze+Ie,et+Te,ke,pt,ke+Ie,pt+Te,O.COLOR_BUFFER_BIT,O.NEAREST):bs?O.copyTexSubImage3D(Fe,Ae,ke,pt,nn+Jn,ze,et,Ie,Te):O.copyTexSubImage2D(Fe,Ae,ke,pt,ze,et,Ie,Te);we.bindFramebuffer(O.READ_FRAMEBUFFER,null),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else bs?E.isDataTexture||E.isData3DTexture?O.texSubImage3D(Fe,Ae,ke,pt,nn,Ie,Te,Le,Lt,Cn,It.data):z.isCompressedArrayTexture?O.compressedTexSubImage3D(Fe,Ae,ke,pt,nn,Ie,Te,Le,Lt,It.data):O.texSubImage3D(Fe,Ae,ke,pt,nn,Ie,Te,Le,Lt,Cn,It):E.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Ae,ke,pt,Ie,Te,Lt,Cn,It.data):E.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Ae,ke,pt,It.width,It.height,Lt,It.data):O.texSubImage2D(O.TEXTURE_2D,Ae,ke,pt,Ie,Te,Lt,Cn,It);we.pixelStorei(O.UNPACK_ROW_LENGTH,yn),we.pixelStorei(O.UNPACK_IMAGE_HEIGHT,gt),we.pixelStorei(O.UNPACK_SKIP_PIXELS,Ms),we.pixelStorei(O.UNPACK_SKIP_ROWS,Sn),we.pixelStorei(O.UNPACK_SKIP_IMAGES,io),Ae===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&O.generateMipmap(Fe),we.unbindTexture()},this.initRenderTarget=function(E){Ge.get(E).__webglFramebuffer===void 0&&Ye.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Ye.setTextureCube(E,0):E.isData3DTexture?Ye.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Ye.setTexture2DArray(E,0):Ye.setTexture2D(E,0),we.unbindTexture()},this.resetState=function(){Y=0,G=0,ae=null,we.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ri}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=_t._getDrawingBufferColorSpace(e),t.unpackColorSpace=_t._getUnpackColorSpace()}};function d0(){let n={camera:new ti(30,1,.01,100),target:new B,home:null,azimuth:.75,elevation:.4,distance:4.2,changed:!0,pushed:null};return n.home={azimuth:n.azimuth,elevation:n.elevation,distance:n.distance},Ki(n),n}function Ki(n){let e=n.distance*Math.cos(n.elevation);n.camera.up.set(0,0,1),n.camera.position.set(n.target.x+e*Math.cos(n.azimuth),n.target.y+e*Math.sin(n.azimuth),n.target.z+n.distance*Math.sin(n.elevation)),n.camera.lookAt(n.target),n.camera.updateMatrixWorld(),n.changed=!0}function dd(n,e,t){n.azimuth-=.006*e,n.elevation=Math.max(-1.5,Math.min(1.5,n.elevation+.006*t)),Ki(n)}function p0(n,[e,t,i]){n.azimuth=e===0&&t===0?-Math.PI/2:Math.atan2(t,e),n.elevation=Math.max(-1.5,Math.min(1.5,Math.atan2(i,Math.hypot(e,t)))),Ki(n)}function Wo(n,e){n.distance=Math.max(.3,Math.min(30,n.distance*e)),Ki(n)}function pd(n,e,t,i){let{right:s,up:r}=hr(n),o=cl(n,n.distance,i);n.target.addScaledVector(s,-e*o).addScaledVector(r,t*o),Ki(n)}var SA=5;function md(n,e){let t=n.pushed;if(n.pushed=e,!t||!e)return;let[i,s,r]=e.position.map((u,f)=>SA*(u-t.position[f])),o=new Et(...t.quat_xyzw),a=new Et(...e.quat_xyzw).multiply(o.invert()),l=a.w<0?-2:2,c=hr(n);n.target.addScaledVector(c.right,-s*n.distance).addScaledVector(c.up,-r*n.distance),n.distance=Math.max(.3,Math.min(30,n.distance*Math.exp(-i))),n.azimuth-=l*a.z,n.elevation=Math.max(-1.5,Math.min(1.5,n.elevation+l*a.y)),Ki(n)}function qu(n){Object.assign(n,n.home),n.target.set(0,0,0),Ki(n)}function hr(n){let e=new B,t=new B,i=new B;return n.camera.matrixWorld.extractBasis(e,t,i),{right:e,up:t,forward:i.negate()}}function cl(n,e,t){return 2*Math.tan(n.camera.fov*Math.PI/360)*e/Math.max(1,t)}function ul(n,e){let{forward:t}=hr(n);return Math.max(.05,e.clone().sub(n.camera.position).dot(t))}var MA={pause:"M8 5v14M16 5v14",play:"M8 5l11 7-11 7z",step:"M6 5l8 7-8 7zM18 5v14",reset:"M5 12a7 7 0 1 0 2.3-5.2M5 4v4.5h4.5",record:"M12 12m-5.5 0a5.5 5.5 0 1 0 11 0a5.5 5.5 0 1 0-11 0",stop:"M7 7h10v10H7z",theme:"M12 4a8 8 0 1 0 0 16zM12 4a8 8 0 0 1 0 16",help:"M9 9a3 3 0 1 1 4.2 2.75c-.8.4-1.2 1-1.2 2.25M12 17.5v.5",fit:"M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",levels:"M12 4l8 14H4zM8 11h8M12 4v14",ghost:"M6 20V10a6 6 0 0 1 12 0v10l-3-2-3 2-3-2zM10 10v.5M14 10v.5",contacts:"M4 16h16M8 16v-6M16 16v-6M6 12l2-2.5 2 2.5M14 12l2-2.5 2 2.5",forces:"M5 19L19 5M19 5h-7M19 5v7",sound:"M4 10v4h3l5 4V6l-5 4zM15.5 9a4 4 0 0 1 0 6M18 6.5a8 8 0 0 1 0 11",names:"M4 5h9l7 7-7 7H4zM8 12h.5",open:"M3 18V6h6l2 2.5h10V18z",headset:"M3 8.5A1.5 1.5 0 0 1 4.5 7h15A1.5 1.5 0 0 1 21 8.5v7a1.5 1.5 0 0 1-1.5 1.5H16l-2.5-2.5h-3L8 17H4.5A1.5 1.5 0 0 1 3 15.5zM7.5 11.5h2M14.5 11.5h2",room:"M3 8.5A1.5 1.5 0 0 1 4.5 7h15A1.5 1.5 0 0 1 21 8.5v7a1.5 1.5 0 0 1-1.5 1.5H16l-2.5-2.5h-3L8 17H4.5A1.5 1.5 0 0 1 3 15.5zM12 3v2M12 19v2",save:"M12 4v11M7 11l5 5 5-5M5 20h14",hand:"M8 12V6a1.5 1.5 0 0 1 3 0v5V4.5a1.5 1.5 0 0 1 3 0V11V6a1.5 1.5 0 0 1 3 0v8c0 4-2 6-5.5 6S7 18 6 15l-1-2.5c-.5-1.5 1.5-2.3 2.2-1z"};function Yu(n){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",MA[n]),e.append(t),e}function hi(n,e,t,i){let s=Object.assign(document.createElement("button"),{type:"button",className:`icon ${n}`});return s.append(Yu(n)),Xo(s,e,t),s.addEventListener("click",()=>i(s)),s}function Xo(n,e,t){n.title=t?`${e} (${t})`:e,n.setAttribute("aria-label",e)}function hl(n,e){n.dataset.icon!==e&&(n.dataset.icon=e,n.replaceChildren(Yu(e)))}var gd=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"],[1e-12,"p"]];function _d(n,e,t=1e-6){if(n==null||!Number.isFinite(n))return{number:"–",unit:e};let i=Math.abs(n);if(i<.005*t)return{number:"0",unit:e};let[s,r]=gd[gd.length-1];for(let[o,a]of gd)if(i>=.9995*o||o<=t){[s,r]=[o,a];break}return{number:Ni(n/s),unit:r+e}}function Ni(n){let e=Math.abs(n);return n.toFixed(e<9.995?2:e<99.95?1:0)}function Yn(n,e,t){let{number:i,unit:s}=_d(n,e,t);return i==="–"?i:`${i} ${s}`}function Fr(n){if(!Number.isFinite(n))return"–";if(n<60)return`${n.toFixed(1)} s`;let e=Math.floor(n);return`${Math.floor(e/60)}:${String(e%60).padStart(2,"0")} min`}function si(n,e,t=`${e}s`){return`${n} ${n===1?e:t}`}var bA={device_lost:"the hand was lost",watchdog:"the haptic loop stood still",not_finite:"a number was not finite",too_fast:"the hand moved too fast",pose_jump:"the hand jumped",turned_too_fast:"the hand turned too fast",orientation_jump:"the hand's direction jumped",contact_stale:"the contact model was too old"},wA={grasped:"The hand took hold of the object",released:"The hand let the object go",armed:"Forces are on",disarmed:"Forces are off",late:"Late",recording_ended:"The recording has ended",not_armed:"Forces stay off",resumed:"Goes on",parameter:"Parameter changed",fault:"Fault",held_back:"Held back",squeezed:"Squeezed"},xd={fault:"ended by a fault",duration:"reached its duration",device_finished:"the hand has finished",stopped:"was stopped"},EA={hand:"simulated hand",web:"mouse or touch",script:"scripted hand",replay:"recorded hand",null:"no hand","":"a recording"};function m0(n){return EA[String(n).split(":")[0]]??n}function Or(n){return bA[n]??String(n).replaceAll("_"," ")}function $u({reason:n,fault:e}){let t=xd[n];return!t||n!=="fault"||!e?t:`${t}: ${Or(e.name)}${e.text?` (${e.text})`:""}`}function g0(n,e){return!n||!(e-n.time<6)?null:`The computer was late (${n.count===1?"once":`${n.count} times so far`}): ${n.text??Or(n.name)}.`}function Zu({kind:n,detail:e,text:t}){let i=wA[n]??String(n).replaceAll("_"," "),r=[n==="fault"||n==="late"?Or(e):n==="held_back"?"":e,t].filter(Boolean).join("; ");return r?`${i}: ${r}`:i}function _0(n){let{object:e,statics:t,grasped:i,contacts:s,clusters:r}=n,o=`The ${e}`;if(s===0)return`${o} ${i?"is in the hand and":"rests and"} touches nothing.`;let a=t.length===1?`the ${t[0]}`:"the scene",l=s===1?"1 contact":`${s} contacts`,c=r===0?"":r===1?" in 1 cluster":` in ${r} clusters`;return n.touching&&n.armed===!1?`${o} touches ${a} at ${l}${c}; forces are off.`:n.touching?`${o} presses on ${a} at ${l}${c}.`:`${o} is close to ${a}: ${l}${c}.`}function x0(n){let{object:e,statics:t,rows:i,pressing:s}=n,r=t.length===1?`the ${t[0]}`:"the scene";if(i===0)return`The ${e} ${n.grasped?"is in the hand and":"rests and"} touches nothing.`;if(s===0)return`The ${e} is close to ${r}: ${i===1?"1 row":`${i} rows`} near, none presses.`;let o=`The ${e} rests on ${s===1?"1 row":`${s} rows`} of ${r}`;return n.armed===!1?`${o}; forces are off.`:`${o}; the hand pulls ${n.newtons}${n.stiffness?`; coupling ${n.stiffness}`:""}.`}function v0({pressing:n,stiffness:e,stretch:t,force:i,heldBack:s,squeezed:r,say:o}){if(r>.1)return"Squeezed: surfaces all around are nearer than the gap that is kept; move it back the way it came.";if(s>.01)return`Held back in ${Math.round(100*s)} % of the last second: the object waits where its contact model ends; move it more slowly.`;if(!(n>0)||!(e>0))return"Nothing limits the object but the coupling.";let a=e*t,l=`${o(e,"N/m")} × ${o(t,"m")}`;return i<.9*a?`The coupling alone limits the force: ${l} would be ${o(a,"N")}; it has levelled off, or the device is at its limit.`:`The coupling alone limits the force: ${l}. The surfaces do not give.`}function y0(n){return n.filter(({presses:e,friction:t,force:i,normal:s})=>{let r=i.reduce((a,l,c)=>a+l*s[c],0),o=Math.hypot(...i.map((a,l)=>a-r*s[l]));return e&&t>0&&o>.98*t*Math.abs(r)}).length}var AA=["what a hand feels","speed","what the eye sees","the cap on deviation","the budget"];function S0(n){return AA.map((i,s)=>[i,n.filter(r=>r.decidedBy===s).length]).filter(([,i])=>i>0).sort(([,i],[,s])=>s-i).map(([i,s])=>`${Math.round(100*s/n.length)} % by ${i}`).join(", ")}function vd(n){let e=new Map;for(let{objectLevel:t}of n)e.set(t,(e.get(t)??0)+1);return[...e].sort(([t],[i])=>t-i)}function M0(n){return n.length>0?[...n.map(({ending:e})=>e),".tex",".mcap"].join(","):""}function b0(n){return`Drop meshes${n.length>0?` (${n.map(({name:t})=>t).join(", ")})`:""}, a texture (.tex), or a recording or a scene in one file (.mcap) anywhere on the page, or click to choose.`}function w0(n){let e=document.getElementById("controls"),t=document.getElementById("view-tools"),i={title:document.getElementById("title"),chip:document.getElementById("state"),open:hi("open","Open a scene or a mesh","O",n.open),pause:hi("pause","Pause","P",n.pause),step:hi("step","One step",".",n.step),reset:hi("reset","Begin again","R",n.reset),record:hi("record","Record","",n.record),theme:hi("theme","Light or dark","",n.theme),help:hi("help","Help","?",n.help),device:document.createElement("select"),views:{},headset:{},act:n};i.device.title="Who moves the object",i.device.setAttribute("aria-label",i.device.title),i.device.addEventListener("change",()=>n.device(i.device.value));let s=(...o)=>{let a=Object.assign(document.createElement("span"),{className:"group"});return a.append(...o),a};e.append(s(i.open),s(i.device),s(i.pause,i.step,i.reset,i.record),s(i.theme,i.help));let r=[["levels","Levels of detail: finest as wireframe","L","wireframe"],["ghost","Ghost of the hand","G","ghost"],["contacts","Contacts and clusters","C","contacts"],["forces","Force and torque","A","forces"],["names","Names of the objects","N","names"]];for(let[o,a,l,c]of r)i.views[c]=hi(o,a,l,()=>n.view(c)),t.append(i.views[c]);return i.sound=hi("sound","Sound of contact","S",n.sound),Sd(i,!1),t.append(i.sound,hi("fit","Fit the view","F",n.fit)),i}function E0(n,e,t){for(let[i,s]of e)n.headset[i]=hi(i==="immersive-ar"?"room":"headset",s,"",()=>t(i)),document.getElementById("view-tools").append(n.headset[i]);yd(n,null)}function yd(n,e){for(let[t,i]of Object.entries(n.headset))i.setAttribute("aria-pressed",String(t===e))}function Sd(n,e){n.sound.setAttribute("aria-pressed",String(e))}function Md(n,e){for(let[t,i]of Object.entries(n.views))i.setAttribute("aria-pressed",String(e[t]))}function A0(n,e){let{state:t,scene:i,shown:s,connected:r}=e;n.title.textContent=i?.title??"",document.title=i?`${i.title} · Thigma`:"Thigma";let o=r?t?.run??"connecting":"lost",a=s?` · ${Fr(s.time)}`:"",l={lost:"connection lost",connecting:"connecting",running:`running${a}`,paused:`paused${a}`,ended:e.progress?"preparing":xd[t?.reason]??"ended"};t?.late&&(l.running+=` · late ${t.late.count}×`);let c=o==="running"&&(s?.bits&4)!==0;t?.replay&&o==="running"&&(l.running=`replaying${a}`),n.chip.textContent=c?`forces off: ${Or(e.faultName())}`:l[o],n.chip.title=o==="ended"?$u(t)??"":t?.late?.text??"",n.chip.dataset.run=c?"fault":o;let u=r&&!!t,f=t?.run==="paused";hl(n.pause,f?"play":"pause"),Xo(n.pause,f?"Go on":"Pause","P"),n.pause.disabled=!u||t.run==="ended",n.step.disabled=!u||!f,n.reset.disabled=n.record.disabled=n.open.disabled=!u;let h=!!t?.recording;hl(n.record,h?"stop":"record"),n.record.classList.toggle("on",h),Xo(n.record,h?`Stop recording ${t.recording}`:"Record from the start",""),TA(n,t,u)}function TA(n,e,t){let i=[...new Set([...e?.devices??[],...e?[e.device]:[]])];n.device.dataset.uris!==i.join(" ")&&(n.device.dataset.uris=i.join(" "),n.device.replaceChildren(...i.map(s=>new Option(m0(s),s)))),n.device.hidden=i.length===0,n.device.disabled=!t||i.length<2,e&&document.activeElement!==n.device&&(n.device.value=e.device)}function T0(n,e){let t=e?`${e.text}|${e.button??""}`:"";if(n.dataset.key===t||(n.dataset.key=t,n.hidden=!e,!e))return;let i=Object.assign(document.createElement("span"),{textContent:e.text});if(n.className=`hint ${e.mood??""}`,n.replaceChildren(...e.icon?[Yu(e.icon)]:[],i),!e.button)return;let s=Object.assign(document.createElement("button"),{type:"button",textContent:e.button});s.addEventListener("click",e.act),n.append(s)}function C0(){return{step:0,turned:!1,unarmedSince:null,touchedAt:null}}function R0(n,e,t,i){let{state:s,scene:r,snapshot:o}=e;if(!e.connected||!s||!r||!o)return null;let a=r.object.name,l=(o.bits&32)!==0,c=(o.bits&1)!==0,u=(o.bits&2)!==0,f=(o.bits&4)!==0;if(e.progress)return null;let h=e.hello?.may_control===!1;if(s.run==="ended")return{text:`The session ${$u(s)??"has ended"}.`,button:h?void 0:"Begin again",act:i.reset,mood:"stop"};if(e.refusal&&t.now<e.refusal.until)return{text:e.refusal.text,mood:"stop"};if(h)return{text:"This page watches. To do more, open the address with its token, as the program has printed it."};if(s.replay)return{text:`A recording: ${s.replay.file.split("/").pop()}`,button:s.devices.includes("web:")?"Take it yourself":void 0,act:()=>i.device("web:")};if(f){let g=s.device.startsWith("web:");return{text:`Forces are off: ${Or(e.faultName())}.${g?` Take hold of the ${a} again to go on.`:""}`,button:g?void 0:"Begin again",act:i.reset,mood:"stop"}}let p=g0(s.late,o.time);return p?{text:p,mood:"stop"}:s.device.startsWith("web:")?s.holder==="other"?{text:"Another page holds the hand; this one watches."}:CA(n,{object:a,grasped:c,armed:u,fading:l,snapshot:o,scene:r,...t}):s.devices.includes("web:")?{text:`A ${s.simulated===!1?"device":"simulated hand"} moves the ${a}.`,button:"Take it yourself",act:()=>i.device("web:"),icon:"hand"}:null}function CA(n,e){let{object:t,grasped:i,armed:s,now:r,newtons:o}=e;if(!i||!e.holding)return n.unarmedSince=null,{text:`Drag the blue ${t}.`,icon:"hand"};if(s?n.unarmedSince=null:n.unarmedSince??=r,!s&&r-n.unarmedSince>.6)return{text:`Taken hold of inside a contact: lift the ${t} off once, then forces come on.`};if(e.fading)return{text:"This page is slow: the force fades until it keeps up, and comes back by itself."};if(o>0&&(n.touchedAt??=r),n.touchedAt===null){let a=e.scene.statics[0]?.name??"scene",l=e.touch?"spread two fingers to move it away":"Shift-drag or the wheel moves it deeper";return{text:`Press it against the ${a}: ${l}. The arrow will be the force in your hand.`}}return!n.turned&&e.turned&&(n.turned=!0),!n.turned&&r-n.touchedAt<12?{text:e.touch?"Two fingers turn it. A finger beside it turns the view.":"Ctrl-drag turns it. Space lets go. Right-drag turns the view."}:null}var Br={grasped:1,armed:2,fault:4,paused:8,ended:16,fading:32,heldBack:64,squeezed:128,constrained:256};var bd=64;var fl=16,RA=48,Ju=48;var dl=class extends Error{},En=(n,e)=>{if(!n)throw new dl(e)};function P0(n){En(n.byteLength>=fl,`a message of ${n.byteLength} bytes has no header`);let e=new DataView(n),t=e.getUint8(0),i=e.getUint8(1),s={bits:e.getUint16(2,!0),count:e.getUint32(4,!0),time:e.getFloat64(8,!0)},r={1:PA,2:NA,3:DA,4:IA,5:LA};return En(r[t],`message type ${t} is not known`),En(i===1,`layout ${i} of message type ${t} is not known`),r[t](n,e,s)}function pl(n,e,t){En(n.byteLength===e,`${t} of ${n.byteLength} bytes, ${e} expected`)}function wd(n,e){let t=e;return(i,s)=>{let r=new i(n,t,s);return t+=4*s,r}}function Ed({positions:n,triangles:e,patchOfTriangle:t},i,s,r){En(n.every(Number.isFinite),`${r} with a position that is no number`),En(e.every(o=>o<i),`${r} with a triangle of a vertex that is not there`),En(t.every(o=>o<s||o===4294967295),`${r} with a triangle of a patch that is not there`)}function PA(n,e,{count:t}){En(n.byteLength>=32,`mesh of ${n.byteLength} bytes, 32 at least`);let[i,s,r,o]=[16,20,24,28].map(c=>e.getUint32(c,!0));pl(n,32+12*i+16*s+4*r+8*o,"mesh");let a=wd(n,32),l={kind:"mesh",number:t,positions:a(Float32Array,3*i),triangles:a(Uint32Array,3*s),patchOfTriangle:a(Uint32Array,s),nodeOfPatch:a(Int32Array,r),parents:a(Int32Array,o),levels:a(Int32Array,o)};return Ed(l,i,r,"mesh"),En(l.nodeOfPatch.every(c=>c>=0&&c<o),"mesh with a patch of a node that is not there"),En(l.parents.every(c=>c>=-1&&c<o),"mesh with a parent that is not there"),En(l.levels.every(c=>c>=0),"mesh with a negative level"),l}function IA(n,e,{bits:t,count:i}){En(n.byteLength>=32,`level of ${n.byteLength} bytes, 32 at least`);let[s,r,o]=[16,20,24].map(c=>e.getUint32(c,!0));pl(n,32+12*s+16*r+4*o,"level");let a=wd(n,32),l={kind:"level",number:i,level:t,positions:a(Float32Array,3*s),triangles:a(Uint32Array,3*r),patchOfTriangle:a(Uint32Array,r),nodeOfPatch:a(Int32Array,o)};return En(t>0,"level 0 comes as a mesh"),Ed(l,s,o,"level"),En(l.nodeOfPatch.every(c=>c>=-1),"level with a patch of no node that could be"),l}function LA(n,e,{count:t}){En(n.byteLength>=32,`relief of ${n.byteLength} bytes, 32 at least`);let[i,s,r]=[16,20,24].map(l=>e.getUint32(l,!0));pl(n,32+12*i+16*s,"relief");let o=wd(n,32),a={kind:"relief",number:t,patches:r,positions:o(Float32Array,3*i),triangles:o(Uint32Array,3*s),patchOfTriangle:o(Uint32Array,s)};return Ed(a,i,r,"relief"),a}function NA(n,e,{bits:t,count:i,time:s}){return En(t>0,"channels without a column"),En(Number.isFinite(s),"channels without a time"),pl(n,fl+4*t*i,"channels"),{kind:"channels",columns:t,rows:i,time:s,values:new Float32Array(n,fl,t*i)}}function DA(n,e,{bits:t,count:i,time:s}){En(n.byteLength>=240,`snapshot of ${n.byteLength} bytes, 240 at least`);let r=e.getUint32(216,!0),o=e.getUint32(236,!0);pl(n,240+Ju*(i+r+o),"snapshot");let a=new Float32Array(n,24,RA),l=f=>[a[f],a[f+1],a[f+2]],c=f=>({position:l(f),quaternion:[a[f+3],a[f+4],a[f+5],a[f+6]]}),u={kind:"snapshot",time:s,bits:t,frame:e.getFloat64(16,!0),object:c(0),ghost:c(7),handle:c(14),grasp:l(21),force:l(24),torque:l(27),contactForce:l(30),contactTorque:l(33),center:l(36),penetration:a[39],stretch:a[40],energy:a[41],modelAge:a[42],modelWeight:a[43],hapticRate:a[44],contactRate:a[45],queryCpu:a[46],metresPerNewton:a[47],contactsFound:e.getUint32(220,!0),contactsDropped:e.getUint32(224,!0),front:e.getUint32(228,!0),fault:e.getUint32(232,!0),contacts:[],clusters:[],rows:[]};En(a.subarray(0,24).every(Number.isFinite),"snapshot with a pose that is no number");for(let f=0;f<i;f++)u.contacts.push(UA(e,240+Ju*f));for(let f=0;f<r;f++)u.clusters.push(FA(e,240+Ju*(i+f)));for(let f=0;f<o;f++)u.rows.push(OA(e,240+Ju*(i+r+f)));return u}var fr=(n,e,t)=>Array.from({length:t},(i,s)=>n.getFloat32(e+4*s,!0));function UA(n,e){let t=n.getUint32(e+44,!0);return{point:fr(n,e,3),normal:fr(n,e+12,3),depth:n.getFloat32(e+24,!0),bound:n.getFloat32(e+28,!0),body:n.getInt32(e+32,!0),objectNode:n.getInt32(e+36,!0),sceneNode:n.getInt32(e+40,!0),objectLevel:t&255,sceneLevel:t>>8&255,status:t>>16&255,decidedBy:t>>>24}}function FA(n,e){return{point:fr(n,e,3),normal:fr(n,e+12,3),depth:n.getFloat32(e+24,!0),force:fr(n,e+28,3),id:n.getInt32(e+40,!0)}}function OA(n,e){let t=n.getUint32(e+44,!0);return{point:fr(n,e,3),normal:fr(n,e+12,3),gap:n.getFloat32(e+24,!0),force:fr(n,e+28,3),friction:n.getFloat32(e+40,!0),kind:t&3,presses:(t&4)!==0}}function I0(n){let e=null;try{e=JSON.parse(n)}catch{}return En(e&&typeof e=="object"&&typeof e.type=="string","a text message without a type"),e}function L0(n){let e=new ArrayBuffer(fl+n.length),t=new DataView(e);return t.setUint8(0,33),t.setUint8(1,1),t.setUint32(4,n.length,!0),new Uint8Array(e,fl).set(n),e}var kA=.004,N0=9.9;function D0(){return{position:[0,0,0],quaternion:[0,0,0,1],clutch:!1,pending:[],latest:-1/0}}function Mi(n,e){return[n[3]*e[0]+n[0]*e[3]+n[1]*e[2]-n[2]*e[1],n[3]*e[1]-n[0]*e[2]+n[1]*e[3]+n[2]*e[0],n[3]*e[2]+n[0]*e[1]-n[1]*e[0]+n[2]*e[3],n[3]*e[3]-n[0]*e[0]-n[1]*e[1]-n[2]*e[2]]}var kr=n=>[-n[0],-n[1],-n[2],n[3]];function ml(n,e){let[t,i,s]=Mi(Mi(n,[...e,0]),kr(n));return[t,i,s]}function ju(n,e){let t=Math.sin(.5*e);return[t*n[0],t*n[1],t*n[2],Math.cos(.5*e)]}function Ku(n,e,t){let i=ml(kr(t.quat_xyzw),e);n.position=n.position.map((s,r)=>Math.max(-N0,Math.min(N0,s+i[r]/t.motion_scale)))}var Qu=(n,e,t,i)=>Ad(n,ju(e,t),i);function Ad(n,e,t){let i=t.quat_xyzw,s=Mi(Mi(Mi(kr(i),e),i),n.quaternion),r=Math.hypot(...s);n.quaternion=s.map(o=>o/r)}function zA(n,e,t=-1/0){let i=n[n.length-1],s=n[n.length-2]?.time??t;i&&i.buttons===e.buttons&&i.time-s<kA?n[n.length-1]=e:n.push(e),n.length>bd&&n.splice(0,n.length-bd)}var Td=n=>({position:[...n.position],quaternion:[...n.quaternion]});function dr(n,e,t=Td(n)){let i={time:Math.max(e,n.latest),...t,buttons:n.clutch?1:0};zA(n.pending,i,n.sent),n.latest=i.time}function Cd(n){let e=n.pending;return n.pending=[],e.length>0&&(n.sent=e[e.length-1].time),e}function U0(n,e,t,i=.7){let s=e.length/3,r=n.length/3,o=new Float64Array(e.length),a=new Float64Array(e.length);for(let d=0;d<s;d++)GA(n,e,d,o,a);let l=new Uint32Array(r+1);for(let d of e)l[d+1]++;for(let d=0;d<r;d++)l[d+1]+=l[d];let c=new Uint32Array(e.length),u=l.slice();for(let d=0;d<e.length;d++)c[u[e[d]]++]=d;let f=[],h=[],p=[],g=new Uint32Array(e.length),y=Math.cos(i);for(let d=0;d<r;d++){let m=c.subarray(l[d],l[d+1]),v=new Map;for(let T of m){let S=3*Math.floor(T/3),C=0,A=0,_=0,w=0;for(let I=0;I<m.length;I++){let k=3*Math.floor(m[I]/3),W=a[S]*a[k]+a[S+1]*a[k+1]+a[S+2]*a[k+2];k!==S&&!(W>y)&&m.length<=31||(w|=1<<(I&31),C+=o[k],A+=o[k+1],_+=o[k+2])}let U=t[Math.floor(T/3)],L=U*2**32+(w>>>0);if(!v.has(L)){v.set(L,f.length/3),p.push(U),f.push(n[3*d],n[3*d+1],n[3*d+2]);let I=Math.hypot(C,A,_)||1;h.push(C/I,A/I,_/I)}g[T]=v.get(L)}}return{positions:Float32Array.from(f),normals:Float32Array.from(h),labels:Float32Array.from(p),index:g}}function GA(n,e,t,i,s){let r=3*e[3*t],o=3*e[3*t+1],a=3*e[3*t+2],l=n[o]-n[r],c=n[o+1]-n[r+1],u=n[o+2]-n[r+2],f=n[a]-n[r],h=n[a+1]-n[r+1],p=n[a+2]-n[r+2],g=[c*p-u*h,u*f-l*p,l*h-c*f],y=Math.hypot(g[0],g[1],g[2]);for(let d=0;d<3;d++)i[3*t+d]=g[d],s[3*t+d]=y>0?g[d]/y:0}function F0(n){let e=new Float64Array(n.length),t=n.reduce((s,r)=>Math.max(s,r),0)+1;for(let s=0;s<n.length;s++){let r=n[s],o=n[s%3===2?s-2:s+1];e[s]=Math.min(r,o)*t+Math.max(r,o)}e.sort();let i=[];for(let s=0;s<e.length;s++)s>0&&e[s]===e[s-1]||i.push(Math.floor(e[s]/t),e[s]%t);return Uint32Array.from(i)}function O0(n){let e=10**Math.floor(Math.log10(n));return e*[5,2,1].find(t=>t*e<=n*(1+1e-9))}function Rd(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let s=0;s<n.length;s++){let r=s%3;n[s]<e[r]&&(e[r]=n[s]),n[s]>t[r]&&(t[r]=n[s])}let i=e.map((s,r)=>.5*(s+t[r]));return{min:e,max:t,center:i,radius:.5*Math.hypot(...e.map((s,r)=>t[r]-s))}}function B0(n){let e=new cn,t=new Me(n,new Yi({colorWrite:!1,transparent:!0}));t.onBeforeRender=s=>s.clearDepth();let i=new Me(n,new ci({transparent:!0,depthWrite:!1,uniforms:{tone:{value:new qe}},vertexShader:`varying vec3 facing; varying vec3 toEye;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  facing = normalize(normalMatrix * normal);
  toEye = -seen.xyz;
  gl_Position = projectionMatrix * seen;
}`,fragmentShader:`varying vec3 facing; varying vec3 toEye; uniform vec3 tone;
void main() {
  float rim = 1.0 - abs(dot(normalize(facing), normalize(toEye)));
  gl_FragColor = vec4(tone, 0.10 + 0.55 * rim * rim * rim);
  #include <colorspace_fragment>
}`}));return t.renderOrder=10,i.renderOrder=11,e.add(t,i),e.visible=!1,{group:e,hidden:t,glass:i}}function k0(n,e){n.hidden.geometry=n.glass.geometry=e}function z0({object:n,ghost:e},t){let i=Math.hypot(...n.position.map((o,a)=>o-e.position[a])),s=new Et(...n.quaternion),r=new Et(...e.quaternion);return i/t+s.angleTo(r)}var G0=n=>new qe(n).toArray(),zr={from:[2.3,-1.5,3.6],colour:16774372,tone:G0(16774372),strength:2.6},Gr={from:[-2.2,2.2,1.2],colour:13624319,tone:G0(13624319),strength:.9};function V0(n){let e=new Wa(16777215,9077624,1.5);e.position.set(0,0,1);let t=new Uo(zr.colour,zr.strength);t.position.set(...zr.from),t.castShadow=!0,t.shadow.mapSize.setScalar(1536),Object.assign(t.shadow.camera,{left:-1.5,right:1.5,top:1.5,bottom:-1.5,near:.5,far:9}),t.shadow.radius=4,t.shadow.bias=-6e-4,t.shadow.normalBias=.006;let i=new Uo(Gr.colour,Gr.strength);i.position.set(...Gr.from);let s=new Ya(16777215,.18);return n.add(e,t,i,s),{sky:e,key:t,rim:i,fill:s}}function H0(n){let e=new Me(new Us(12,12),new za({opacity:.2}));return e.receiveShadow=!0,e.renderOrder=-1,n.add(e),e}var W0="thigma-theme";function eh(){let n=document.documentElement.dataset.theme;return n||(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light")}function X0(n){let e=null;try{e=localStorage.getItem(W0)}catch{}return(e==="light"||e==="dark")&&(document.documentElement.dataset.theme=e),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>n()),function(){let i=eh()==="dark"?"light":"dark";document.documentElement.dataset.theme=i;try{localStorage.setItem(W0,i)}catch{}n()}}function Ct(n){return getComputedStyle(document.documentElement).getPropertyValue(`--${n}`).trim()}var ks=["#0a8f83","#23ab6a","#7cc542","#bdd334","#e6d32e","#f5a32b","#ea7430","#d64a45"];function Vr(n){return ks[Math.max(0,Math.min(ks.length-1,n))]}var Id=512,$0=16,xl=new B(0,0,1);function pr(n={}){return new Va(n)}function Hr(n={}){return new Yi({transparent:!0,opacity:.42,depthTest:!1,depthWrite:!1,...n})}function Z0(){let n=new cn,e=new Wt(.5,.5,1,20).rotateX(Math.PI/2).translate(0,0,.5),t=new Ds(1.35,3.6,28).rotateX(Math.PI/2).translate(0,0,1.8),i=[];for(let s of[pr(),Hr()]){let r=new Me(e,s),o=new Me(t,s);r.renderOrder=o.renderOrder=s.depthTest?0:20,i.push({shaft:r,head:o,material:s}),n.add(r,o)}return n.visible=!1,{group:n,parts:i}}function J0(n,e,t,i){let s=t.length();if(n.group.visible=s>.2*i,!n.group.visible)return;n.group.position.copy(e),n.group.quaternion.setFromUnitVectors(xl,t.clone().divideScalar(s));let r=Math.min(i,s/3.6);for(let{shaft:o,head:a}of n.parts)o.scale.set(r,r,Math.max(1e-6*i,s-3.4*r)),a.scale.setScalar(r),a.position.set(0,0,s-3.6*r)}function j0(n,e){for(let{material:t}of n.parts)t.color.set(e)}var gl=72,zs=10,q0=.055;function K0(){let n=new cn,e=VA(),t=new Ds(.15,.38,24),i=[];for(let s of[pr(),Hr()]){let r=new Me(e,s),o=new Me(t,s);r.renderOrder=o.renderOrder=s.depthTest?0:20,i.push({ring:r,head:o,material:s}),n.add(r,o)}return n.visible=!1,{group:n,parts:i,ring:e}}function VA(){let n=[],e=[],t=[];for(let s=0;s<=gl;s++){let r=2*Math.PI*s/gl;for(let o=0;o<zs;o++){let a=2*Math.PI*o/zs,l=Math.cos(a),c=Math.sin(a);e.push(l*Math.cos(r),l*Math.sin(r),c);let u=1+q0*l;n.push(u*Math.cos(r),u*Math.sin(r),q0*c);let f=(o+1)%zs;if(s<gl){let h=s*zs+o,p=s*zs+f;t.push(h,p,h+zs,p,p+zs,h+zs)}}}let i=new _n;return i.setAttribute("position",new mn(Float32Array.from(n),3)),i.setAttribute("normal",new mn(Float32Array.from(e),3)),i.setIndex(t),i}function Q0(n,e,t,i,s){if(n.group.visible=i>.01&&t.lengthSq()>0,!n.group.visible)return;n.group.position.copy(e),n.group.quaternion.setFromUnitVectors(xl,t.clone().normalize()),n.group.scale.setScalar(s);let r=Math.max(1,Math.round(300/360*gl*Math.min(1,i)));n.ring.setDrawRange(0,r*zs*6);let o=2*Math.PI*r/gl;for(let{head:a}of n.parts)a.position.set(Math.cos(o),Math.sin(o),0),a.rotation.set(0,0,o),a.scale.setScalar(Math.min(1,.25+4*i))}function e_(n,e){for(let{material:t}of n.parts)t.color.set(e)}function th(n,e,t,i,s){let r=new Ua(e,t,i);return r.frustumCulled=!1,r.renderOrder=s,r.count=0,r.setColorAt(0,new qe),n.add(r),r}function t_(){let n=new cn,e=new ds(1,12,8),t=new Wt(.22,.22,1,8).rotateX(Math.PI/2).translate(0,0,.5),i=new $i(1,.12,8,40),s=(...o)=>th(n,...o),r={group:n,dots:[],needles:[],rings:[]};for(let[o,a]of[[pr(),1],[Hr({opacity:.45}),21]])r.dots.push(s(e,o,Id,a)),r.needles.push(s(t,o,Id,a));for(let[o,a]of[[pr(),1],[Hr({opacity:.55}),22]])r.rings.push(s(i,o,$0,a));return r}var Y0=new xt,Ld=new Et,Nd=new B,Dd=new B,Ud=new qe;function Fd(n,e,t,i,s){let r=Math.min(Id,e.length);for(let a=0;a<r;a++){let{point:l,normal:c,level:u}=e[a];Nd.set(...l),Ld.setFromUnitVectors(xl,Dd.set(...c).normalize()),Ud.set(Vr(u)),Pd(n.dots,a,i,i),Pd(n.needles,a,i,5.5*i)}_l(n.dots,r),_l(n.needles,r);let o=Math.min($0,t.length);for(let a=0;a<o;a++){Nd.set(...t[a].point),Ld.setFromUnitVectors(xl,Dd.set(...t[a].normal).normalize()),Ud.set(s);let l=i*(2.6+2.4*Math.sqrt(Math.max(0,Math.min(1,t[a].share))));Pd(n.rings,a,l,l)}_l(n.rings,o)}function Pd(n,e,t,i){Y0.compose(Nd,Ld,Dd.set(t,t,i));for(let s of n)s.setMatrixAt(e,Y0),s.setColorAt(e,Ud)}function _l(n,e){for(let t of n)t.count=e,t.instanceMatrix.needsUpdate=!0,t.instanceColor&&(t.instanceColor.needsUpdate=!0)}function n_(){let n=pr(),e=Hr({opacity:.5}),t=new cn,i=new Wt(1,1,1,10).rotateX(Math.PI/2).translate(0,0,.5),s=new ds(1,16,12),r=[],o=[];for(let a of[n,e]){let l=new Me(i,a),c=new Me(s,a);l.renderOrder=c.renderOrder=a.depthTest?0:23,r.push(l),o.push(c),t.add(l,c)}return{group:t,rods:r,knobs:o,materials:[n,e]}}function i_(n,e,t,i){let s=t.clone().sub(e),r=s.length();n.group.position.copy(e),r>0&&n.group.quaternion.setFromUnitVectors(xl,s.divideScalar(r));for(let o of n.rods)o.scale.set(i,i,Math.max(r,1e-9*i));for(let o of n.knobs)o.position.set(0,0,r),o.scale.setScalar(2.6*i)}function s_(n,e){for(let t of n.materials)t.color.set(e)}var Bd=64,Od=new B(0,0,1);function a_(){let n=new cn,e={planes:new Wt(1,1,.06,28).rotateX(Math.PI/2),points:new ds(.36,12,8),forces:new Wt(.16,.16,1,8).rotateX(Math.PI/2).translate(0,0,.5),heads:new Ds(.42,1,16).rotateX(Math.PI/2).translate(0,0,.5),cones:new Ds(1,1,28,1,!0).translate(0,-.5,0).rotateX(-Math.PI/2)},t={group:n};for(let[i,s]of Object.entries(e)){let r=i==="cones"||i==="planes",o=r?pr({transparent:!0,opacity:i==="cones"?.34:.72,depthWrite:!1,side:2}):pr(),a=Hr({opacity:r?.16:.5,side:r?2:0});t[i]=[th(n,s,o,Bd,r?3:2),th(n,s,a,Bd,22)]}return t}var r_=new xt,nh=new Et,vl=new B,ih=new B,HA=new B,o_=new qe;function kd(n,e,{size:t,longest:i},s){let r=e.slice(0,Bd),o=Math.max(1e-30,...r.map(({force:c})=>Math.hypot(...c))),a={planes:0,points:0,forces:0,heads:0,cones:0},l=(c,u,f)=>{r_.compose(vl,nh,HA.set(u,u,f));for(let h of n[c])h.setMatrixAt(a[c],r_),h.setColorAt(a[c],o_);a[c]+=1};for(let{point:c,normal:u,gap:f,force:h,friction:p,kind:g,presses:y}of r){o_.set(y?s.press:s.near);let d=c.map((C,A)=>C+f*u[A]),m=y?t:.62*t;if(nh.setFromUnitVectors(Od,ih.set(...u).normalize()),vl.set(...g===1?d:c),l("points",m,m),vl.set(...g===1?c:d),l(g===2?"points":"planes",m,m),!y)continue;vl.set(...c),p>0&&(nh.setFromUnitVectors(Od,ih.set(...u).multiplyScalar(-1).normalize()),l("cones",.8*i*p,.8*i));let v=Math.hypot(...h);if(!(v>0))continue;nh.setFromUnitVectors(Od,ih.set(...h).divideScalar(v));let T=i*(.25+.75*v/o),S=Math.min(1.1*t,.5*T);l("forces",t,T-S),vl.addScaledVector(ih,T-S),l("heads",t,S)}for(let[c,u]of Object.entries(a))_l(n[c],u)}function c_(n,e){let{positions:t,triangles:i,patchOfTriangle:s}=n,r=t.length/3,o=new Uint32Array(r),a=new Map,l=(y,d)=>Math.floor(t[3*y+d]/e)+1e5;for(let y=0;y<r;y++){let d=(l(y,0)*2e5+l(y,1))*2e5+l(y,2),m=a.get(d);m===void 0&&a.set(d,m=a.size),o[y]=m}let c=new Float32Array(3*a.size),u=new Uint32Array(a.size),f=new Float64Array(3*a.size);for(let y=0;y<r;y++){u[o[y]]+=1;for(let d=0;d<3;d++)f[3*o[y]+d]+=t[3*y+d]}for(let y=0;y<c.length;y++)c[y]=f[y]/u[Math.floor(y/3)];let h=0;for(let y=0;y<r;y++){let d=0;for(let m=0;m<3;m++)d+=(t[3*y+m]-c[3*o[y]+m])**2;h=Math.max(h,d)}let p=[],g=[];for(let y=0;y<i.length;y+=3){let[d,m,v]=[o[i[y]],o[i[y+1]],o[i[y+2]]];d===m||m===v||v===d||(p.push(d,m,v),g.push(s[y/3]))}return{mesh:{...n,positions:c,triangles:Uint32Array.from(p),patchOfTriangle:Uint32Array.from(g)},deviation:Math.sqrt(h)}}var l_=[.064,.032,.016,.008],WA=.6,XA=4e3;function u_(n,e,t,i,s){if(e<XA)return 0;for(let r=0;r<l_.length;r++){let o=-1-r,a=l_[r]*t;if(!n.has(o)&&WA*a>i)continue;if((n.get(o)??s(o,a))<=i)return o}return 0}function h_(n,e,t){let i=0;return(n??[]).forEach(({free:s,triangles:r,deviation:o},a)=>{a>0&&!s&&r>0&&Number.isFinite(o)&&o!==null&&o<=t*e&&r<n[i].triangles&&(i=a)}),i}function f_(n,e){for(let t=n;t>0;t--)if(e(t))return t;return 0}function d_(n,e,t){let i=new Float64Array(3*t).fill(1/0),s=new Float64Array(3*t).fill(-1/0);for(let o=0;o<e.length;o++)for(let a=0;e[o]>=0&&a<3;a++){let l=3*e[o]+a,c=n[3*o+a];c<i[l]&&(i[l]=c),c>s[l]&&(s[l]=c)}let r=new Float32Array(4*t).fill(-1);for(let o=0;o<t;o++){if(!(i[3*o]<=s[3*o]))continue;let a=0;for(let l=0;l<3;l++)r[4*o+l]=.5*(i[3*o+l]+s[3*o+l]),a+=(s[3*o+l]-i[3*o+l])**2;r[4*o+3]=.5*Math.sqrt(a)}return r}function p_(n,e,t,i){i.fill(0);for(let{point:[s,r,o]}of e)for(let a=0;a<i.length;a++){let l=n[4*a+3]+t;if(n[4*a+3]<0)continue;let c=n[4*a]-s,u=n[4*a+1]-r,f=n[4*a+2]-o;c*c+u*u+f*f<l*l&&(i[a]=255)}}function m_(n,e){let t=e.length,i=new Uint32Array(t);for(let h of n)i[h]++;let s=YA(e),r=i.slice();for(let h=t-1;h>=0;h--){let p=s[h];e[p]>=0&&(r[e[p]]+=r[p])}let o=new Uint32Array(t),a=new Uint32Array(t),l=new Uint32Array(t),c=0;for(let h of s){let p=e[h];o[h]=p<0?c:l[p],a[h]=o[h]+r[h],p<0?c=a[h]:l[p]=a[h],l[h]=o[h]+i[h]}let u=new Uint32Array(n.length),f=o.slice();for(let h=0;h<n.length;h++)u[f[n[h]]++]=h;return{order:u,begin:o,end:a}}function YA(n){let e=n.map(()=>0);for(let r of n)r>=0&&e[r]++;let t=new Uint32Array(n.length),i=n.length,s=[];for(let r=0;r<n.length;r++)e[r]===0&&s.push(r);for(;s.length>0;){let r=s.pop();t[--i]=r,n[r]>=0&&--e[n[r]]===0&&s.push(n[r])}if(i!==0)throw new RangeError("the hierarchy runs in a circle");return t}function g_(n,e,t){t.fill(0);for(let{node:i,level:s}of e)if(!(i<0||i>=n.begin.length))for(let r=n.begin[i];r<n.end[i];r++){let o=n.order[r];(t[o]===0||t[o]>s+1)&&(t[o]=Math.min(255,s+1))}}var __=(n,e)=>n.patchOfTriangle[e]===4294967295?-1:n.patchOfTriangle[e];function x_(n,e,t,i){return Int32Array.from(n,s=>{let r=s;for(;e[r]>=0&&t[e[r]]<=i;)r=e[r];return r})}function v_(n,e,t,i){i.fill(0);let s=t.filter(({node:r})=>r>=0&&r<n.begin.length);for(let r=0;r<e.length;r++){let o=e[r];if(!(o<0||o>=n.begin.length))for(let{node:a,level:l}of s)n.begin[a]<=n.begin[o]&&n.end[o]<=n.end[a]&&(i[r]===0||i[r]>l+1)&&(i[r]=Math.min(255,l+1))}}function y_(n){let e=n*.61803398875%1,t=[.62,.5,.72][n%3],i=.55,s=r=>{let o=(r+e*12)%12;return Math.round(255*(t-i*Math.min(t,1-t)*Math.max(-1,Math.min(o-3,9-o,1))))};return[s(0),s(8),s(4)]}var qo=24,mr=1024;function M_(n){return{patchLevels:{value:n},spotCount:{value:0},spotRadius:{value:1},spots:{value:Array.from({length:qo},()=>new Ht)},levelColours:{value:ks.map((e,t)=>new qe(Vr(t)))},onlyActive:{value:0},patchTints:{value:null},tinted:{value:0}}}var b_=`attribute float patchNumber;
uniform sampler2D patchLevels;
uniform sampler2D patchTints;
uniform float tinted;
varying vec3 meshPoint;
flat varying vec2 patchState;
flat varying vec4 patchTint;`,w_=`meshPoint = position;
patchState = vec2(0.0);
patchTint = vec4(0.0);
if (patchNumber >= 0.0) {
  int patchIndex = int(patchNumber + 0.5);
  ivec2 cell = ivec2(patchIndex % ${mr}, patchIndex / ${mr});
  patchState = floor(texelFetch(patchLevels, cell, 0).rg * 255.0 + 0.5);
  if (tinted > 0.5) patchTint = vec4(texelFetch(patchTints, cell, 0).rgb, 1.0);
}`,E_=`varying vec3 meshPoint;
flat varying vec2 patchState;
flat varying vec4 patchTint;
uniform int spotCount;
uniform float spotRadius;
uniform float onlyActive;
uniform vec4 spots[${qo}];
uniform vec3 levelColours[${ks.length}];
/// The colour of a point of the surface: its own, of its patch, or of a contact nearby.
vec3 markedColour(vec3 base) {
  int level = int(patchState.x) - 1;
  float share = level >= 0 ? 0.92 : 0.0;
  if (level < 0 && patchState.y > 0.5) {
    float nearest = 1.0;
    for (int k = 0; k < ${qo}; k++) {
      if (k >= spotCount) break;
      float d = distance(meshPoint, spots[k].xyz) / spotRadius;
      if (d < nearest) { nearest = d; level = int(spots[k].w); }
    }
    share = 0.85 * (1.0 - smoothstep(0.3, 1.0, nearest));
  }
  if (onlyActive > 0.5 && share < 0.02) discard;
  vec3 tone = levelColours[clamp(level, 0, ${ks.length-1})];
  if (patchTint.a > 0.5) return mix(patchTint.rgb, tone, 0.75 * step(0.9, share));
  return mix(base, tone, share);
}`;function A_(n){let e=new Ga({roughness:.62,metalness:0});return e.onBeforeCompile=t=>{Object.assign(t.uniforms,n),t.vertexShader=t.vertexShader.replace("#include <common>",`#include <common>
${b_}`).replace("#include <begin_vertex>",`#include <begin_vertex>
${w_}`),t.fragmentShader=t.fragmentShader.replace("#include <common>",`#include <common>
${E_}`).replace("#include <color_fragment>",`#include <color_fragment>
diffuseColor.rgb = markedColour(diffuseColor.rgb);`)},e}var zd=n=>`vec3(${n.map(e=>e.toFixed(5)).join(", ")})`,S_=({from:n})=>zd(new B(...n).normalize().toArray());function T_(n,e,t){return new ci({uniforms:{...n,base:e,sky:t},vertexShader:`${b_}
varying vec3 facing;
void main() {
  ${w_}
  facing = mat3(modelMatrix) * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,fragmentShader:`${E_}
uniform vec3 base;
uniform float sky;
varying vec3 facing;
void main() {
  vec3 n = normalize(facing);
  vec3 light = mix(vec3(0.25, 0.22, 0.19), vec3(1.0), 0.5 + 0.5 * n.z) * sky + ${zr.strength.toFixed(3)} * ${zd(zr.tone)} * max(0.0, dot(n, ${S_(zr)}))
    + ${Gr.strength.toFixed(3)} * ${zd(Gr.tone)} * max(0.0, dot(n, ${S_(Gr)})) + 0.28;
  vec3 lit = markedColour(base) * light * 0.31831;
  float peak = max(lit.r, max(lit.g, lit.b)), over = peak - 0.76; // bright ones flatten out, as by NeutralToneMapping
  if (over > 0.0) lit *= (1.0 - 0.0576 / (over + 0.24)) / peak;
  gl_FragColor = vec4(lit, 1.0);
  #include <colorspace_fragment>
}`})}function yl(n,e=m_(n.nodeOfPatch,n.parents)){let t=n.triangles.length/3,i=n.nodeOfPatch.length,s=Float32Array.from({length:t},(d,m)=>__(n,m)),r=U0(n.positions,n.triangles,s),o=new _n;o.setAttribute("position",new mn(r.positions,3)),o.setAttribute("normal",new mn(r.normals,3)),o.setAttribute("patchNumber",new mn(r.labels,1)),o.setIndex(new mn(r.index,1));let a=new Uint8Array(2*mr*C_(n)),l=R_(a,ji),c=M_(l),u={value:new qe},f={value:1},h={rich:A_(c),plain:T_(c,u,f)};h.rich.color=u.value;let p=new Me(o,h.rich);p.castShadow=p.receiveShadow=!0;let g=new Fa(new _n,new rr({transparent:!0,opacity:.16}));g.visible=!1;let y=new cn;return y.add(p,g),{group:y,solid:p,lines:g,uniforms:c,geometry:o,mesh:n,ranges:e,materials:h,colour:u,sky:f,state:a,patchLevels:l,bytes:new Uint8Array(i),near:new Uint8Array(i),balls:d_(r.positions,r.labels,i)}}var C_=n=>Math.max(1,Math.ceil(n.nodeOfPatch.length/mr)),$A=new Map([[Go,1],[ji,2],[ui,4]]);function R_(n,e){let t=new Cr(n,mr,n.length/(mr*$A.get(e)),e,Xn);return t.unpackAlignment=1,t.needsUpdate=!0,t}function P_(n,e){let{uniforms:t,mesh:i}=n;if(t.tinted.value=e===null?0:1,e===null||n.tintedAt===e)return;let s=i.parents?x_(i.nodeOfPatch,i.parents,i.levels,e):i.nodeOfPatch,r=new Uint8Array(4*mr*C_(i));s.forEach((o,a)=>r.set([...y_(Math.max(0,o)),255],4*a)),t.patchTints.value?.dispose(),t.patchTints.value=R_(r,ui),n.tintedAt=e}function sh(n,{base:e,line:t,sky:i}){n.colour.value.set(e),n.sky.value=i,n.lines.material.color.set(t)}function rh(n,e){n.solid.material=e?n.materials.rich:n.materials.plain}function I_(n,e,t){n.solid.visible=e!=="none",n.uniforms.onlyActive.value=e==="active"?1:0,n.lines.visible=t>0,n.lines.material.opacity=t,t>0&&!n.lines.geometry.index&&(n.lines.geometry.setAttribute("position",new mn(n.mesh.positions,3)),n.lines.geometry.setIndex(new mn(F0(n.mesh.triangles),1)))}function L_(n,e,t,i,s){let{bytes:r,near:o,balls:a,state:l,uniforms:c}=n;n.mesh.parents?g_(n.ranges,e,r):v_(n.ranges,n.mesh.nodeOfPatch,e,r);let u=t.slice(0,qo);p_(a,u,i,o);for(let f=0;f<r.length;f++)a[4*f+3]>s&&(r[f]=0),l[2*f]=r[f],l[2*f+1]=o[f];n.patchLevels.needsUpdate=!0,c.spotCount.value=u.length,c.spotRadius.value=i,u.forEach(({point:f,level:h},p)=>c.spots.value[p].set(...f,h))}function N_(n,e,t=qo){let i=[];for(let s of n){if(i.length===t)break;i.some(o=>o.level===s.level&&ZA(o.point,s.point)<e)||i.push(s)}return i}var ZA=(n,e)=>Math.hypot(n[0]-e[0],n[1]-e[1],n[2]-e[2]);function D_(n){n.geometry.dispose(),n.patchLevels.dispose(),n.uniforms.patchTints.value?.dispose(),n.lines.geometry.dispose();for(let e of Object.values(n.materials))e.dispose();n.lines.material.dispose()}function Gd(n,e){let t=yl(n);return{group:t.group,geometry:t.geometry,finest:t,about:e,levels:new Map,made:new Map,relief:null,browsed:null,wireframe:!1,drawn:0,rich:!0,colours:null}}function U_(n,e){return e>0&&!n.levels.has(e)&&oh(n,e)}function oh({about:n},e){let t=n.level_list?.[e];return!!t&&!t.free&&t.triangles>0}function F_(n,e){n.levels.has(e.level)||O_(n,e.level,yl(e,n.finest.ranges))}function O_(n,e,t){n.levels.set(e,t),n.group.add(t.group),n.colours&&sh(t,n.colours),rh(t,n.rich),lh(n)}function B_(n,e){let{nodeOfPatch:t,parents:i,levels:s}=n.finest.mesh;n.relief||e.patches!==t.length||(n.relief=yl({...e,nodeOfPatch:t,parents:i,levels:s},n.finest.ranges),n.group.add(n.relief.group),n.colours&&sh(n.relief,n.colours),rh(n.relief,n.rich),lh(n))}function Vd(n,e){n.colours=e;for(let t of Sl(n))sh(t,e)}function Hd(n,e){n.rich=e;for(let t of Sl(n))rh(t,e)}var Sl=n=>[n.finest,...n.levels.values(),...n.relief?[n.relief]:[]],k_=(n,e)=>n.levels.get(e)??n.finest;function ah(n,{wireframe:e=n.wireframe,browsed:t=n.browsed}){Object.assign(n,{wireframe:e,browsed:t}),lh(n)}function Wd(n,e,t){let{level_list:i,radius:s,triangles:r}=n.about;return i?.some((o,a)=>a>0&&oh(n,a))?h_(i,e,t):u_(n.made,r,s,t*e,(o,a)=>{let{mesh:l,deviation:c}=c_(n.finest.mesh,a);return O_(n,o,yl(l,n.finest.ranges)),n.made.set(o,c),c})}function z_(n,e){let t=e<0?e:f_(e,i=>n.levels.has(i));return t===n.drawn?!1:(n.drawn=t,lh(n),!0)}var Xd=(n,e=n.drawn)=>k_(n,e),G_=n=>n.drawn===0&&n.relief?n.relief:Xd(n),JA=(n,e)=>e!==n.relief&&![...n.made.keys()].some(t=>n.levels.get(t)===e);function lh(n){let{browsed:e,wireframe:t}=n,i=e===null?t?null:G_(n):k_(n,e);for(let s of Sl(n)){let r=e!==null&&s===i;P_(s,r?e:null);let o=s===i?"whole":i===null&&JA(n,s)?"active":"none";I_(s,o,r?.3:t&&e===null&&s===n.finest?.16:0)}}function qd(n,e,t){let i=.03*t,s=.075*t,r=a=>n.levels.get(a),o=n.browsed===null&&!n.wireframe;for(let a of Sl(n)){let l=({level:u})=>o?a===G_(n):a===n.finest?!r(u)||n.browsed!==null:a===r(u),c=e.filter(l);L_(a,c,N_(c,i),s,o?2*s:1/0)}}function V_(n){for(let e of Sl(n))D_(e)}var Ml=[{pixels:2,shadows:!0,rich:!0,off:0},{pixels:1,shadows:!0,rich:!0,off:0},{pixels:1,shadows:!1,rich:!0,off:.5},{pixels:1,shadows:!1,rich:!1,off:.5},{pixels:1,shadows:!1,rich:!1,off:1},{pixels:1,shadows:!1,rich:!1,off:2},{pixels:1,shadows:!1,rich:!1,off:4},{pixels:1,shadows:!1,rich:!1,off:6}],X_=3,jA=1/15,q_=.045,KA=.012,H_=2,QA=3,eT=60;function Y_({step:n=0,fixed:e=!1}={}){return{step:n,fixed:e,seen:0,mean:0,patience:eT,climbed:!1}}function $_(n,e){if(n.seen+=1,n.fixed||n.seen<=H_)return!1;let t=n.seen-H_;return n.mean+=(e-n.mean)/Math.min(t,8),t>=QA&&n.mean>q_&&n.step<Ml.length-1?(n.climbed&&(n.patience*=4),W_(n,1),!0):t>=n.patience&&n.mean<KA&&n.step>0?(W_(n,-1),!0):!1}function W_(n,e){Object.assign(n,{step:n.step+e,seen:0,mean:0,climbed:e<0})}function Z_(n,e){return!e&&n<q_?0:Math.max(.25*n,Math.min(n,jA-n-.01))}var Yd=1.6;function tT(){let n=document.createElement("canvas").getContext("webgl2"),e=n?.getExtension("WEBGL_debug_renderer_info"),t=e?n.getParameter(e.UNMASKED_RENDERER_WEBGL):"";return n?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)}function J_(n,e=null){let t=e==="plain"||e!=="full"&&tT(),i=new Hu({canvas:n,antialias:!t,alpha:!0,powerPreference:"high-performance"});i.outputColorSpace=ei,i.toneMapping=Za,i.shadowMap.enabled=!0,i.shadowMap.type=Pr,i.shadowMap.autoUpdate=!1;let s=new Ia,r=new cn;s.add(r);let o={canvas:n,renderer:i,scene:s,root:r,view:d0(),plain:t,lights:V0(s),ground:H0(s),radius:1,size:1,object:null,statics:[],ghost:null,force:Z0(),twist:K0(),marks:t_(),rows:a_(),spring:n_(),dirty:!0,options:{wireframe:!1,ghost:!0,contacts:!0,forces:!0,names:!0},editing:!1,start:null,wants:()=>{},wanted:new Set,last:null,moved:!0,resized:!0,fence:null,begun:0,rested:0,pace:Y_({step:t?X_:0,fixed:e==="full"})};return r.add(o.force.group,o.twist.group,o.marks.group,o.rows.group,o.spring.group),o.spring.group.visible=!1,o}function j_(n,e,t,i=!1){let s=i?n.last:null;for(let r of $n(n))n.root.remove(r.group),V_(r);n.ghost&&n.root.remove(n.ghost.group),n.last=null,n.start={position:e.start.position,quaternion:e.start.quat_xyzw},K_(n),n.object=Gd(t.get(e.object.mesh),e.object),n.statics=e.statics.map(r=>{let o=Gd(t.get(r.mesh),r);return bl(o.group,{position:r.position,quaternion:r.quat_xyzw}),o});for(let r of $n(n))ah(r,{wireframe:n.options.wireframe}),Hd(r,Ml[n.pace.step].rich);n.ghost=B0(n.object.geometry),bl(n.object.group,n.start),n.root.add(n.object.group,...n.statics.map(r=>r.group),n.ghost.group),n.size=e.object.radius,n.wanted.clear(),i||rT(n),n.moved=!0,uh(n),s&&wl(n,s)}function K_(n){for(let{group:e}of[n.force,n.twist,n.spring])e.visible=!1;Fd(n.marks,[],[],1,Ct("ring")),kd(n.rows,[],{size:1,longest:1},{near:Ct("contact"),press:Ct("press")})}function Q_(n,e){if(n.editing!==e&&(n.editing=e,!!n.object)){if(!e&&n.last){wl(n,n.last);return}K_(n),n.ghost.group.visible=!1;for(let t of $n(n))qd(t,[],n.size);bl(n.object.group,n.start),n.dirty=n.moved=!0}}var $n=n=>n.object?[n.object,...n.statics]:[];function ex(n,e){for(let t of $n(n))t.about.mesh===e.number&&F_(t,e);n.last&&El(n,n.last),n.dirty=n.moved=!0}function tx(n,e){for(let t of $n(n))t.about.mesh===e.number&&B_(t,e);n.last&&El(n,n.last),n.dirty=n.moved=!0}function nx(n,e,t){ah(e,{browsed:t}),t!==null&&ch(n,e,t),n.last&&El(n,n.last),n.dirty=n.moved=!0}var nT=3,iT=1e3;async function ch(n,e,t){let i=`${e.about.mesh} ${t}`,{wanted:s}=n;if(!U_(e,t)||s.has(i))return;s.add(i),(await n.wants(e.about.mesh,t)).ok||setTimeout(()=>s.delete(i),iT)}function sT(n){let{off:e}=Ml[n.pace.step],t=new B,i=!1;for(let s of $n(n)){let{center:r,radius:o,relief:a}=s.about;n.root.localToWorld(t.set(...r).applyQuaternion(s.group.quaternion).add(s.group.position));let l=Math.max(n.view.camera.near,ul(n.view,t)-o/n.radius),c=cl(n.view,l,n.canvas.clientHeight)*n.radius,u=Wd(s,c,e-(a??0)/c);if(ch(n,s,u),i=z_(s,u)||i,s!==n.object)continue;let f=Wd(s,c,nT*e);ch(n,s,f),k0(n.ghost,Xd(s,f).geometry)}i&&n.last&&El(n,n.last)}function bl(n,e){n.position.fromArray(e.position),n.quaternion.fromArray(e.quaternion)}function rT(n){let e=[];for(let{group:i,geometry:s}of[n.object,...n.statics]){let r=Rd(s.attributes.position.array);i.updateMatrix();for(let o=0;o<8;o++){let a=[0,1,2].map(l=>o&1<<l?r.max[l]:r.min[l]);e.push(...new B(...a).applyMatrix4(i.matrix).toArray())}}let t=Rd(e);n.radius=t.radius>0?t.radius:1,n.root.scale.setScalar(1/n.radius),n.root.position.fromArray(t.center).multiplyScalar(-1/n.radius),n.ground.position.z=(t.min[2]-t.center[2])/n.radius-.012,n.root.updateMatrixWorld()}function uh(n){let e=Number(Ct("sky"));if(n.object){Vd(n.object,{base:Ct("held"),line:Ct("held-line"),sky:e});for(let t of n.statics)Vd(t,{base:Ct("fixed"),line:Ct("fixed-line"),sky:e});n.ghost.glass.material.uniforms.tone.value.set(Ct("ghost"))}j0(n.force,Ct("force")),e_(n.twist,Ct("torque")),s_(n.spring,Ct("hand")),n.ground.material.opacity=Number(Ct("shadow")),n.lights.sky.intensity=e,n.dirty=!0}function wl(n,e){if(!n.object||(n.last=e,n.editing))return;bl(n.object.group,e.object),bl(n.ghost.group,e.ghost);let t=(e.bits&1)!==0,i=new B(...e.grasp),s=new B(...e.handle.position);n.ghost.group.visible=n.options.ghost&&t&&z0(e,n.size)>.004,n.spring.group.visible=n.options.ghost&&t,i_(n.spring,i,s,.012*n.size),oT(n,e,i),El(n,e),n.dirty=n.moved=!0}function oT(n,e,t){if(!n.options.forces){n.force.group.visible=n.twist.group.visible=!1;return}let i=e.metresPerNewton>0?e.metresPerNewton:.5*n.size,s=new B(...e.force).multiplyScalar(Yd*i);s.clampLength(0,4*n.size),J0(n.force,t,s,.045*n.size);let r=new B(...e.torque),o=.5*n.size*n.size/i;Q0(n.twist,t,r,r.length()/o,.42*n.size)}function El(n,e){if(n.editing)return;let t=(e.bits&Br.constrained)!==0,i=n.options.contacts&&!t?e.contacts:[];kd(n.rows,n.options.contacts?e.rows:[],{size:.045*n.size,longest:.34*n.size},{near:Ct("contact"),press:Ct("press")});let s=Math.max(1e-30,...e.clusters.map(a=>Math.hypot(...a.force)));Fd(n.marks,i.map(a=>({point:a.point,normal:a.normal,level:a.objectLevel})),n.options.contacts?e.clusters.map(a=>({point:a.point,normal:a.normal,share:Math.hypot(...a.force)/s})):[],.011*n.size,Ct("ring"));let r=(a,l)=>{if(qd(a,l.map(({point:c,node:u,level:f})=>({point:aT(a.group,c),node:u,level:f})),n.size),a.wireframe)for(let{level:c}of l)ch(n,a,c)},o=t&&n.object.about.levels<=1?[]:e.contacts;r(n.object,o.map(a=>({point:a.point,node:a.objectNode,level:a.objectLevel}))),n.statics.forEach((a,l)=>r(a,o.filter(c=>c.body===l).map(c=>({point:c.point,node:c.sceneNode,level:c.sceneLevel}))))}function aT(n,e){return new B(...e).sub(n.position).applyQuaternion(n.quaternion.clone().conjugate()).toArray()}function ix(n,e){Object.assign(n.options,e);for(let t of $n(n))ah(t,{wireframe:n.options.wireframe});n.last&&wl(n,n.last),n.dirty=!0}function Al(n){let{clientWidth:e,clientHeight:t}=n.canvas;e===0||t===0||n.renderer.xr.isPresenting||(n.resized=!0,n.view.camera.aspect=e/t,n.view.camera.fov=e<t?38:30,n.view.camera.updateProjectionMatrix(),Ki(n.view))}function lT(n){let{clientWidth:e,clientHeight:t}=n.canvas,{pixels:i,shadows:s,rich:r}=Ml[n.pace.step];n.renderer.setPixelRatio(n.plain?1:Math.min(i,devicePixelRatio)),e>0&&t>0&&n.renderer.setSize(e,t,!1),n.lights.key.castShadow=n.ground.visible=s;for(let o of $n(n))Hd(o,r);n.resized=!1,n.moved=!0}function sx(n){let e=n.renderer.getContext(),t=performance.now();if(n.fence&&!e.isContextLost()){if(e.getSyncParameter(n.fence,e.SYNC_STATUS)!==e.SIGNALED)return!1;e.deleteSync(n.fence),n.fence=null;let i=.001*(t-n.begun);n.rested=t+1e3*Z_(i,n.plain),n.resized||=$_(n.pace,i)}return t>=n.rested}function rx(n){if(!(n.dirty||n.view.changed))return!1;let e=n.renderer.getContext();return n.resized&&lT(n),sT(n),n.dirty=n.view.changed=!1,n.renderer.shadowMap.needsUpdate=n.moved,n.moved=!1,n.begun=performance.now(),n.renderer.render(n.scene,n.view.camera),n.fence=e.fenceSync(e.SYNC_GPU_COMMANDS_COMPLETE,0),e.flush(),!0}function ox(n,e){let t=n.root.localToWorld(new B(...e));return 2*Math.tan(n.view.camera.fov*Math.PI/360)*ul(n.view,t)*n.radius/Math.max(1,n.canvas.clientHeight)}var ax=.008;function lx(n){let{canvas:e}=n.stage,t={player:n,pointers:new Map,mode:null,keys:new Set,touch:matchMedia("(pointer: coarse)").matches};e.addEventListener("contextmenu",i=>i.preventDefault()),e.addEventListener("pointerdown",i=>cT(t,i)),e.addEventListener("pointermove",i=>hT(t,i));for(let i of["pointerup","pointercancel"])e.addEventListener(i,s=>pT(t,s));return e.addEventListener("wheel",i=>mT(t,i),{passive:!1}),addEventListener("keydown",i=>_T(t,i)),addEventListener("keyup",({key:i})=>t.keys.delete(i)),addEventListener("blur",()=>t.keys.clear()),e.addEventListener("dblclick",i=>{i.button===2&&qu(n.stage.view)}),t}function cT(n,e){let{canvas:t}=n.player.stage;t.focus({preventScroll:!0}),!n.player.claims(e)&&(t.setPointerCapture(e.pointerId),n.pointers.set(e.pointerId,{x:e.clientX,y:e.clientY}),n.touch=e.pointerType==="touch",n.touch?n.pointers.size===1&&(n.mode=uT(n,e)&&n.player.mayMove()?"hand":"view"):e.button===0?n.mode=n.player.mayMove()?"hand":"view":n.mode=e.button===1||e.shiftKey?"pan":"view",n.mode==="hand"&&n.player.press(),t.classList.toggle("grabbing",n.mode==="hand"))}function uT({player:{stage:n}},e){if(!n.object)return!1;let t=n.canvas.getBoundingClientRect(),i=new lt((e.clientX-t.left)/t.width*2-1,1-(e.clientY-t.top)/t.height*2),s=new Rr;return s.setFromCamera(i,n.view.camera),s.intersectObject(n.object.finest.solid,!1).length>0}function hT(n,e){let t=n.pointers.get(e.pointerId);if(t){if(n.pointers.size===2)dT(n,e,t);else{let i=e.getCoalescedEvents?.()??[];for(let s of i.length>0?i:[e])fT(n,s,s.clientX-t.x,s.clientY-t.y),t.x=s.clientX,t.y=s.clientY}t.x=e.clientX,t.y=e.clientY,n.mode==="hand"&&n.player.give()}}function fT(n,e,t,i){let{stage:s}=n.player;if(!(t===0&&i===0)){if(n.mode==="view")return dd(s.view,t,i);if(n.mode==="pan")return pd(s.view,t,i,s.canvas.clientHeight);if(n.mode==="hand")return e.ctrlKey||e.altKey||e.metaKey?hh(n,t,i,0,e.timeStamp):e.shiftKey?Yo(n,0,0,-i,e.timeStamp):Yo(n,t,i,0,e.timeStamp)}}function Yo(n,e,t,i,s){let{stage:r,hand:o}=n.player,a=ox(r,n.player.grasp()),{right:l,up:c,forward:u}=hr(r.view),f=[0,1,2].map(h=>a*(e*l.getComponent(h)-t*c.getComponent(h)+i*u.getComponent(h)));Ku(o,f,n.player.workspace()),dr(o,s/1e3),n.player.moved(!1)}function hh(n,e,t,i,s){let{stage:r,hand:o}=n.player,{right:a,up:l,forward:c}=hr(r.view),u=n.player.workspace();Qu(o,l.toArray(),ax*e,u),Qu(o,a.toArray(),ax*t,u),i!==0&&Qu(o,c.toArray(),i,u),dr(o,s/1e3),n.player.moved(!0)}function dT(n,e,t){let[i]=[...n.pointers].filter(([f])=>f!==e.pointerId).map(([,f])=>f),s={x:t.x-i.x,y:t.y-i.y},r={x:e.clientX-i.x,y:e.clientY-i.y},o=(Math.hypot(r.x,r.y)||1)/(Math.hypot(s.x,s.y)||1),a=Math.atan2(s.x*r.y-s.y*r.x,s.x*r.x+s.y*r.y),l=.5*(e.clientX-t.x),c=.5*(e.clientY-t.y),{stage:u}=n.player;n.mode==="hand"?(hh(n,l,c,a,e.timeStamp),Yo(n,0,0,-200*Math.log(o),e.timeStamp)):(pd(u.view,l,c,u.canvas.clientHeight),Wo(u.view,1/o))}function pT(n,e){n.pointers.delete(e.pointerId),!(n.pointers.size>0)&&(n.mode=null,n.player.stage.canvas.classList.remove("grabbing"))}function mT(n,e){e.preventDefault();let t=e.deltaY*(e.deltaMode===1?16:e.deltaMode===2?400:1);n.mode==="hand"?(Yo(n,0,0,-.4*t,e.timeStamp),n.player.give()):Wo(n.player.stage.view,Math.exp(.0012*t))}var cx={ArrowLeft:[-1,0,0],ArrowRight:[1,0,0],ArrowUp:[0,-1,0],ArrowDown:[0,1,0],PageUp:[0,0,1],PageDown:[0,0,-1]},gT=160;function _T(n,e){let t=e.target===n.player.stage.canvas||e.target===document.body;!cx[e.key]||!t||(e.preventDefault(),Object.assign(n,{turns:e.ctrlKey||e.altKey||e.metaKey,views:e.shiftKey}),n.keys.add(e.key))}function ux(n,e){if(n.keys.size===0)return;let{hand:t,stage:i}=n.player,s=gT*Math.min(.1,e),[r,o,a]=[0,1,2].map(l=>s*[...n.keys].reduce((c,u)=>c+cx[u][l],0));!t.clutch||n.views?(dd(i.view,r,o),a!==0&&Wo(i.view,Math.exp(-.004*a))):n.turns?hh(n,r,o,.01*a,performance.now()):Yo(n,r,o,a,performance.now()),n.player.give()}var xT=.12;function hx(n,e,t,i){let s=[...navigator.getGamepads?.()??[]].find(a=>a?.connected);if(!s)return!1;let{player:r}=n,o=a=>Math.abs(s.axes[a]??0)>xT?s.axes[a]:0;if(s.buttons[0]?.pressed&&r.mayMove()&&r.press(),s.buttons[1]?.pressed&&r.letGo(),r.hand.clutch){let a=220*Math.min(.1,e),l=(s.buttons[7]?.value??0)-(s.buttons[6]?.value??0);(o(0)||o(1)||l)&&Yo(n,a*o(0),a*o(1),a*l,performance.now()),(o(2)||o(3))&&hh(n,a*o(2),a*o(3),0,performance.now())}return vT(n,s,Math.min(1,t/i)),!0}function vT(n,e,t){let i=performance.now();!e.vibrationActuator?.playEffect||t<.02||i-(n.rumbled??-1e9)<60||(n.rumbled=i,e.vibrationActuator.playEffect("dual-rumble",{duration:80,strongMagnitude:t,weakMagnitude:.5*t}).catch(()=>{}))}function fx(n,e){let t={url:n,on:e,worker:new Worker("worker.js"),isOpen:!1,attempt:0,nextId:1,asked:new Map,received:0,bytes:0,posted:0,gone:0,stopped:!1};return t.worker.onmessage=({data:i})=>yT(t,i),t.worker.onerror=()=>_x(t,"The page could not start its worker. Reload the page."),t.worker.postMessage({open:n,origin:performance.timeOrigin}),t}function yT(n,e){if(!n.stopped)if(e.data!==void 0)try{ST(n,e.data)}finally{n.worker.postMessage({taken:1})}else e.opened?(Object.assign(n,{isOpen:!0,attempt:0}),n.on.opened()):e.lost?xx(n,e.lost):e.gone!==void 0&&(n.gone=e.gone)}function ST(n,e){if(!n.isOpen)return;n.received+=1,n.bytes+=typeof e=="string"?e.length:e.byteLength;let t=null;try{t=typeof e=="string"?I0(e):P0(e)}catch(i){if(!(i instanceof dl))throw i;_x(n,`The program says something this page does not understand: ${i.message}. Reload the page.`);return}t.type==="ack"&&MT(n,t),n.on.message(t)}function MT(n,e){let t=n.asked.get(e.id);n.asked.delete(e.id),t?.(e)}function gr(n,e){if(!n.isOpen)return Promise.resolve({ok:!1,reason:"The program is not connected."});let t=n.nextId;return n.nextId=t===2147483647?1:t+1,n.worker.postMessage({text:JSON.stringify({...e,id:t})}),new Promise(i=>n.asked.set(t,i))}function dx(n,e){n.isOpen&&e.length>0&&n.worker.postMessage({hand:e})}var px=n=>n?.worker.postMessage({letGo:!0});function mx(n,e){return n.isOpen?(n.posted+=e.byteLength,n.worker.postMessage({bytes:e},[e]),!0):!1}var gx=n=>Math.max(0,n.posted-n.gone);function _x(n,e){n.stopped=!0,n.worker.postMessage({stop:!0}),xx(n,e)}function xx(n,e){Object.assign(n,{isOpen:!1,posted:0,gone:0,attempt:n.attempt+1});for(let t of n.asked.values())t({ok:!1,reason:"The connection was lost."});n.asked.clear(),n.on.lost(e)}function Rt(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}function bT({min:n,max:e,scale:t},i){let s=t==="log"?Math.log(i/n)/Math.log(e/n):(i-n)/(e-n);return Math.max(0,Math.min(1,s))}function vx({min:n,max:e,scale:t},i){return t==="log"?n*(e/n)**i:n+i*(e-n)}var Tl=n=>String(Number(n.toPrecision(3)));function yx(n,e){return{parent:n,ask:e,rows:new Map}}function Sx(n,e){let t=new Set(e.map(i=>i.name));for(let[i,s]of n.rows)t.has(i)||(s.box.remove(),n.rows.delete(i));for(let i of e)n.rows.has(i.name)||n.rows.set(i.name,ET(n,i)),AT(n.rows.get(i.name),i)}function wT(n,e){let t=Rt("div","parameter"),i=Rt("div","parameter-top"),s=Rt("span","words"),r=Rt("label","",e.label),o=Rt("p","note"),a=Rt("p","refusal"),l=Rt("p","warning");a.setAttribute("role","alert"),s.setAttribute("role","radiogroup"),s.setAttribute("aria-label",e.label);let c=e.choices.map((f,h)=>{let p=Object.assign(Rt("button","chip-button",f),{type:"button"});return p.setAttribute("role","radio"),p.addEventListener("click",()=>{u.parameter.value!==h&&Cl(n,u,h)}),s.append(p),p});i.append(r,s),t.append(i,o,a,l),n.parent.append(t);let u={box:t,buttons:c,help:o,refusal:a,warning:l,parameter:e,busy:!1,next:null};return u}function ET(n,e){if(e.kind==="choice")return wT(n,e);let t=Rt("div","parameter"),i=Rt("label","",e.label),s=Object.assign(Rt("input"),{type:"range",min:0,max:1,step:.001,id:`parameter-${e.name}`});i.htmlFor=s.id;let r=Object.assign(Rt("input","value"),{type:"text",inputMode:"decimal"});r.setAttribute("aria-label",`${e.label}, ${e.unit}`);let o=Rt("span","unit",e.unit),a=Rt("p","note"),l=Rt("p","refusal");l.setAttribute("role","alert");let c=Rt("div","parameter-top"),u=Rt("p","warning"),f={box:t,slider:s,number:r,help:a,refusal:l,warning:u,parameter:e,busy:!1,next:null,on:null};return e.kind==="optional"&&(f.on=Object.assign(Rt("input","switch"),{type:"checkbox"}),f.on.setAttribute("aria-label",`${e.label} on`),f.kept=e.value||vx(e,.5),f.on.addEventListener("change",()=>Cl(n,f,f.on.checked?Number(Tl(f.kept)):0)),c.append(f.on)),c.append(i,r,o),t.append(c,s,a,l,u),n.parent.append(t),s.addEventListener("input",()=>{let h=Number(Tl(vx(f.parameter,Number(s.value))));r.value=Tl(h),Cl(n,f,h)}),r.addEventListener("change",()=>{let h=Number(r.value.replace(",","."));r.value.trim()!==""&&Number.isFinite(h)?Cl(n,f,h):Mx(f,`"${r.value}" is not a number.`)}),f}async function Cl(n,e,t){if(e.busy){e.next=t;return}e.busy=!0;let i=await n.ask(e.parameter.name,t);if(e.busy=!1,e.next!==null){let s=e.next;e.next=null,Cl(n,e,s);return}if(!i.ok){Mx(e,i.reason??"Refused.");return}e.refusal.textContent="",e.parameter={...e.parameter,value:i.value??t},$d(e),e.box.classList.remove("changed"),e.box.offsetWidth,e.box.classList.add("changed")}function Mx(n,e){let{value:t,unit:i,choices:s}=n.parameter,r=s?.length>0?s[t]:n.on&&t===0?"off":`${Tl(t)} ${i}`.trim();n.refusal.textContent=`${e.replace(/[.]?$/,".")} It stays at ${r}.`,$d(n)}function AT(n,e){n.parameter=e;let t=e.begins_again?" Begins again.":"";n.help.textContent=e.locked??`${e.help??""}${t}`,n.warning.textContent=e.warning?`Risky: ${e.warning}.`:"";let i=!!e.locked;n.box.classList.toggle("locked",i);for(let s of[n.slider,n.number,n.on,...n.buttons??[]])s&&(s.disabled=i);!n.busy&&document.activeElement!==n.number&&$d(n)}function $d(n){let{value:e}=n.parameter;if(n.buttons?.forEach((i,s)=>i.setAttribute("aria-checked",String(s===e))),n.buttons)return;let t=n.on!==null&&e===0;n.on&&(n.on.checked=!t,t||(n.kept=e),n.box.classList.toggle("off",t)),n.slider.value=bT(n.parameter,t?n.kept:e),n.number.value=t?"off":Tl(e)}var TT=200;function bx(n,e){let t=Rt("div",`event ${e.kind}`);for(t.append(Rt("time","",`${Ni(e.time)} s`),Rt("span","",Zu(e))),n.prepend(t);n.childElementCount>TT;)n.lastChild.remove()}var CT=[["Drag","moves the hand in the plane of the screen"],["Wheel while dragging, or Shift + drag","moves it away from you and back"],["Ctrl or Alt + drag","turns it"],["Space","lets go, or takes hold"],["Arrow keys, Page up and down","move the hand that holds, on the picture; with Ctrl or Alt they turn it, with Shift the view"],["Right drag, wheel","turns and zooms the view; middle drag shifts it"],["Touch","one finger on the object moves it, a second turns and lifts it; beside it fingers move the view"],["Gamepad","sticks move and turn, triggers push and pull, A holds, B lets go; it rumbles with the force"],["VR or AR","where a headset is there: the trigger holds, squeezing frees the controller, its stick turns and sizes the scene"],["Scene tab","put a scene together: drop meshes, drag the handles, Ctrl+Z takes a step back"],["P . R O","pause, one step, begin again, open a scene"],["F L G C A N","fit the view; levels of detail, ghost, contacts, arrows, names on and off"],["S","sound of contact on and off: changes of the force"],["1 to 6, + -","look along the axes, as the buttons of the compass do; nearer and farther"]];function wx(n){let e=Rt("h2","","The mouse is the hand"),t=Rt("p","lead","Drag the blue object: the ghost shows where your hand is, the object where it may be, and the line between them, as long as the force is strong, is what a haptic device would let you feel."),i=Rt("dl");for(let[o,a]of CT){let l=/^(Drag|Touch|Gamepad)$/.test(o)?"":"for-mouse";i.append(Rt("dt",l,o),Rt("dd",l,a))}let s=Rt("p","note");s.append($o("force","force on the hand"),$o("torque","torque, turning along the arc"),$o("ring","clusters of contacts"),$o("levels","dots: contacts with their normals, in the colour of their level of detail"),$o("contact","under constraints, discs: planes that the object keeps off, with the points they keep off"),$o("press","those that press, with their force and the cone it may lie in"));let r=Object.assign(Rt("button","primary","Close"),{type:"button"});r.addEventListener("click",()=>n.close()),n.addEventListener("click",o=>{o.target===n&&n.close()}),n.replaceChildren(e,t,i,s,r)}function $o(n,e){let t=Rt("span",`key ${n}`,e);return t.prepend(Rt("i")),t}var RT="uplot",PT="u-hz",IT="u-vt",LT="u-title",NT="u-wrap",DT="u-under",UT="u-over",FT="u-axis",qr="u-off",OT="u-select",BT="u-cursor-x",kT="u-cursor-y",zT="u-cursor-pt",GT="u-legend",VT="u-live",HT="u-inline",WT="u-series",XT="u-marker",Ex="u-label",qT="u-value",Pl="width",Il="height";var Ax="bottom",Zo="left",Zd="right",fp="#000",Tx=fp+"0",Jd="mousemove",Cx="mousedown",jd="mouseup",Rx="mouseenter",Px="mouseleave",Ix="dblclick",YT="resize",$T="scroll",Lx="change",gh="dppxchange",dp="--",na=typeof window<"u",np=na?document:null,jo=na?window:null,ZT=na?navigator:null,At,fh;function ip(){let n=devicePixelRatio;At!=n&&(At=n,fh&&rp(Lx,fh,ip),fh=matchMedia(`(min-resolution: ${At-.001}dppx) and (max-resolution: ${At+.001}dppx)`),Yr(Lx,fh,ip),jo.dispatchEvent(new CustomEvent(gh)))}function bi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function sp(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function jt(n,e,t){n.style[e]=t+"px"}function Qi(n,e,t,i){let s=np.createElement(n);return e!=null&&bi(s,e),t?.insertBefore(s,i),s}function Di(n,e){return Qi("div",n,e)}var Nx=new WeakMap;function _s(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Nx.get(n);r!=o&&(n.style.transform=r,Nx.set(n,r),e<0||t<0||e>i||t>s?bi(n,qr):sp(n,qr))}var Dx=new WeakMap;function Ux(n,e,t){let i=e+t,s=Dx.get(n);i!=s&&(Dx.set(n,i),n.style.background=e,n.style.borderColor=t)}var Fx=new WeakMap;function Ox(n,e,t,i){let s=e+""+t,r=Fx.get(n);s!=r&&(Fx.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var pp={passive:!0},JT={...pp,capture:!0};function Yr(n,e,t,i){e.addEventListener(n,t,i?JT:pp)}function rp(n,e,t,i){e.removeEventListener(n,t,pp)}na&&ip();function es(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:wi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function hv(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var fv=n=>n!=null,dv=n=>n!=null&&n>0,vh=hv(fv),jT=hv(dv);function KT(n,e,t,i=0,s=!1){let r=s?jT:vh,o=s?dv:fv;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Bt,l??-Bt]}function yh(n,e,t,i){let s=zx(n),r=zx(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Gs:pv,a=s==1?wi:Ui,l=r==1?Ui:wi,c=a(o(Ln(n))),u=l(o(Ln(e))),f=Ko(t,c),h=Ko(t,u);return t==10&&(c<0&&(f=kt(f,-c)),u<0&&(h=kt(h,-u))),i||t==2?(n=f*s,e=h*r):(n=xv(n,f),e=Sh(e,h)),[n,e]}function mp(n,e,t,i){let s=yh(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var gp=.1,Bx={mode:3,pad:gp},Nl={pad:0,soft:null,mode:0},QT={min:Nl,max:Nl};function _h(n,e,t,i){return Mh(t)?kx(n,e,t):(Nl.pad=t,Nl.soft=i?0:null,Nl.mode=i?3:0,kx(n,e,QT))}function bt(n,e){return n??e}function eC(n,e,t){for(e=bt(e,0),t=bt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function kx(n,e,t){let i=t.min,s=t.max,r=bt(i.pad,0),o=bt(s.pad,0),a=bt(i.hard,-Bt),l=bt(s.hard,Bt),c=bt(i.soft,Bt),u=bt(s.soft,-Bt),f=bt(i.mode,0),h=bt(s.mode,0),p=e-n,g=Gs(p),y=ri(Ln(n),Ln(e)),d=Gs(y),m=Ln(d-g);(p<1e-24||m>10)&&(p=0,(n==0||e==0)&&(p=1e-24,f==2&&c!=Bt&&(r=0),h==2&&u!=-Bt&&(o=0)));let v=p||y||1e3,T=Gs(v),S=Ko(10,wi(T)),C=v*(p==0?n==0?.1:1:r),A=kt(xv(n-C,S/10),24),_=n>=c&&(f==1||f==3&&A<=c||f==2&&A>=c)?c:Bt,w=ri(a,A<_&&n>=_?_:ts(_,A)),U=v*(p==0?e==0?.1:1:o),L=kt(Sh(e+U,S/10),24),I=e<=u&&(h==1||h==3&&L>=u||h==2&&L<=u)?u:-Bt,k=ts(l,L>I&&e<=I?I:ri(I,L));return w==k&&w==0&&(k=100),[w,k]}var tC=new Intl.NumberFormat(na?ZT.language:"en-US"),_p=n=>tC.format(n),Ei=Math,mh=Ei.PI,Ln=Ei.abs,wi=Ei.floor,In=Ei.round,Ui=Ei.ceil,ts=Ei.min,ri=Ei.max,Ko=Ei.pow,zx=Ei.sign,Gs=Ei.log10,pv=Ei.log2,nC=(n,e=1)=>Ei.sinh(n)*e,Kd=(n,e=1)=>Ei.asinh(n/e),Bt=1/0;function Gx(n){return(Gs((n^n>>31)-(n>>31))|0)+1}function op(n,e,t){return ts(ri(n,e),t)}function mv(n){return typeof n=="function"}function vt(n){return mv(n)?n:()=>n}var iC=()=>{},gv=n=>n,_v=(n,e)=>e,sC=n=>null,Vx=n=>!0,Hx=(n,e)=>n==e,rC=/\.\d*?(?=9{6,}|0{6,})/gm,$r=n=>{if(yv(n)||xr.has(n))return n;let e=`${n}`,t=e.match(rC);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${$r(s)}e${r}`}return kt(n,i)};function Wr(n,e){return $r(kt($r(n/e))*e)}function Sh(n,e){return $r(Ui($r(n/e))*e)}function xv(n,e){return $r(wi($r(n/e))*e)}function kt(n,e=0){if(yv(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return In(i)/t}var xr=new Map;function vv(n){return((""+n).split(".")[1]||"").length}function Ul(n,e,t,i){let s=[],r=i.map(vv);for(let o=e;o<t;o++){let a=Ln(o),l=kt(Ko(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:kt(u,f);s.push(h),xr.set(h,f)}}return s}var Dl={},xp=[],Qo=[null,null],_r=Array.isArray,yv=Number.isInteger,oC=n=>n===void 0;function Wx(n){return typeof n=="string"}function Mh(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function aC(n){return n!=null&&typeof n=="object"}var lC=Object.getPrototypeOf(Uint8Array),Sv="__proto__";function ea(n,e=Mh){let t;if(_r(n)){let i=n.find(s=>s!=null);if(_r(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=ea(n[s],e)}else t=n.slice()}else if(n instanceof lC)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Sv&&(t[i]=ea(n[i],e))}else t=n;return t}function An(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=Sv&&(Mh(n[s])?An(n[s],ea(i[s])):n[s]=ea(i[s]))}return n}var cC=0,uC=1,hC=2;function fC(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function dC(n,e){if(gC(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return _C(o[0])||(o=mC(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=e?e[o][c]:uC,p=[];for(let g=0;g<u.length;g++){let y=u[g],d=r.get(l[g]);y===null?h!=cC&&(f[d]=y,h==hC&&p.push(d)):f[d]=y}fC(f,p,s),i.push(f)}}return i}var pC=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function mC(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function gC(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function _C(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ri(1,wi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Mv=["January","February","March","April","May","June","July","August","September","October","November","December"],bv=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function wv(n){return n.slice(0,3)}var xC=bv.map(wv),vC=Mv.map(wv),yC={MMMM:Mv,MMM:vC,WWWW:bv,WWW:xC};function Rl(n){return(n<10?"0":"")+n}function SC(n){return(n<10?"00":n<100?"0":"")+n}var MC={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Rl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Rl(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Rl(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Rl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Rl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>SC(n.getMilliseconds())};function vp(n,e){e=e||yC;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?MC[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var bC=new Intl.DateTimeFormat().resolvedOptions().timeZone;function wC(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==bC?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var Ev=n=>n%1==0,xh=[1,2,2.5,5],EC=Ul(10,-32,0,xh),Av=Ul(10,0,32,xh),AC=Av.filter(Ev),Xr=EC.concat(Av),yp=`
`,Tv="{YYYY}",Xx=yp+Tv,Cv="{M}/{D}",Ll=yp+Cv,dh=Ll+"/{YY}",Rv="{aa}",TC="{h}:{mm}",Jo=TC+Rv,qx=yp+Jo,Yx=":{ss}",Pt=null;function Pv(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ul(10,0,3,xh).filter(Ev):Ul(10,-3,0,xh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Tv,Pt,Pt,Pt,Pt,Pt,Pt,1],[s*28,"{MMM}",Xx,Pt,Pt,Pt,Pt,Pt,1],[s,Cv,Xx,Pt,Pt,Pt,Pt,Pt,1],[i,"{h}"+Rv,dh,Pt,Ll,Pt,Pt,Pt,1],[t,Jo,dh,Pt,Ll,Pt,Pt,Pt,1],[e,Yx,dh+" "+Jo,Pt,Ll+" "+Jo,Pt,qx,Pt,1],[n,Yx+".{fff}",dh+" "+Jo,Pt,Ll+" "+Jo,Pt,qx,Pt,1]];function u(f){return(h,p,g,y,d,m)=>{let v=[],T=d>=o,S=d>=r&&d<o,C=f(g),A=kt(C*n,3),_=Qd(C.getFullYear(),T?0:C.getMonth(),S||T?1:C.getDate()),w=kt(_*n,3);if(S||T){let U=S?d/r:0,L=T?d/o:0,I=A==w?A:kt(Qd(_.getFullYear()+L,_.getMonth()+U,1)*n,3),k=new Date(In(I/n)),W=k.getFullYear(),N=k.getMonth();for(let V=0;I<=y;V++){let Y=Qd(W+L*V,N+U*V,1),G=Y-f(kt(Y*n,3));I=kt((+Y+G)*n,3),I<=y&&v.push(I)}}else{let U=d>=s?s:d,L=wi(g)-wi(A),I=w+L+Sh(A-w,U);v.push(I);let k=f(I),W=k.getHours()+k.getMinutes()/t+k.getSeconds()/i,N=d/i,V=h.axes[p]._space,Y=m/V;for(;I=kt(I+d,n==1?0:3),!(I>y);)if(N>1){let G=wi(kt(W+N,6))%24,K=f(I).getHours()-G;K>1&&(K=-1),I-=K*i,W=(W+N)%24;let ne=v[v.length-1];kt((I-ne)/d,3)*Y>=.7&&v.push(I)}else v.push(I)}return v}}return[l,c,u]}var[CC,RC,PC]=Pv(1),[IC,LC,NC]=Pv(.001);Ul(2,-53,53,[1]);function $x(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Zx(n,e){return(t,i,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,f,h,p;return i.map(g=>{let y=n(g),d=y.getFullYear(),m=y.getMonth(),v=y.getDate(),T=y.getHours(),S=y.getMinutes(),C=y.getSeconds(),A=d!=l&&a[2]||m!=c&&a[3]||v!=u&&a[4]||T!=f&&a[5]||S!=h&&a[6]||C!=p&&a[7]||a[1];return l=d,c=m,u=v,f=T,h=S,p=C,A(y)})}}function DC(n,e){let t=vp(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Qd(n,e,t){return new Date(n,e,t)}function Jx(n,e){return e(n)}var UC="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function jx(n,e){return(t,i,s,r)=>r==null?dp:e(n(i))}function FC(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function OC(n,e){return n.series[e].fill(n,e)}var BC={show:!0,live:!0,isolate:!1,mount:iC,markers:{show:!0,width:2,stroke:FC,fill:OC,dash:"solid"},idx:null,idxs:null,values:[]};function kC(n,e){let t=n.cursor.points,i=Di(),s=t.size(n,e);jt(i,Pl,s),jt(i,Il,s);let r=s/-2;jt(i,"marginLeft",r),jt(i,"marginTop",r);let o=t.width(n,e,s);return o&&jt(i,"borderWidth",o),i}function zC(n,e){let t=n.series[e].points;return t._fill||t._stroke}function GC(n,e){let t=n.series[e].points;return t._stroke||t._fill}function VC(n,e){return n.series[e].points.size}var ep=[0,0];function HC(n,e,t){return ep[0]=e,ep[1]=t,ep}function ph(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function tp(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var WC={show:!0,x:!0,y:!0,lock:!1,move:HC,points:{one:!1,show:kC,size:VC,width:0,stroke:GC,fill:zC},bind:{mousedown:ph,mouseup:ph,click:ph,dblclick:ph,mousemove:tp,mouseleave:tp,mouseenter:tp},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Iv={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Sp=An({},Iv,{filter:_v}),Lv=An({},Sp,{size:10}),Nv=An({},Iv,{show:!1}),Mp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Dv="bold "+Mp,Uv=1.5,Kx={show:!0,scale:"x",stroke:fp,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Dv,side:2,grid:Sp,ticks:Lv,border:Nv,font:Mp,lineGap:Uv,rotate:0},XC="Value",qC="Time",Qx={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function YC(n,e,t,i,s){return e.map(r=>r==null?"":_p(r))}function $C(n,e,t,i,s,r,o){let a=[],l=xr.get(s)||0;t=o?t:kt(Sh(t,s),l);for(let c=t;c<=i;c=kt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ap(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Gs:pv,u=wi(c(t));s=Ko(l,u),l==10&&(s=Xr[es(s,Xr)]);let f=t,h=s*l;l==10&&(h=Xr[es(h,Xr)]);do a.push(f),f=f+s,l==10&&!xr.has(f)&&(f=kt(f,xr.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=Xr[es(h,Xr)]));while(f<=i);return a}function ZC(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?ap(n,e,ri(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?ap(n,e,ri(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var Fv=/./,JC=/[12357]/,jC=/[125]/,ev=/1/,lp=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function KC(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?Fv:l(7,o)-u>=c?JC:l(5,o)-u>=c?jC:ev;if(f==ev){let h=Ln(l(1,o)-u);if(h<c)return lp(e.slice().reverse(),a.distr,f,Ui(c/h)).reverse()}return lp(e,a.distr,f,1)}function QC(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Ln(l(1,o)-l(2,o));return c<a?lp(e.slice().reverse(),3,Fv,Ui(a/c)).reverse():e}function eR(n,e,t,i){return i==null?dp:e==null?"":_p(e)}var tv={show:!0,scale:"y",stroke:fp,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Dv,side:3,grid:Sp,ticks:Lv,border:Nv,font:Mp,lineGap:Uv,rotate:0};function tR(n,e){let t=3+(n||1)*2;return kt(t*e,3)}function nR(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Ln(o-r),l=n.series[e],c=a/(l.points.space*At);return i[1]-i[0]<=c}var nv={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},Ov=(n,e,t,i,s)=>s,iv={show:!0,auto:!0,sorted:0,gaps:Ov,alpha:1,facets:[An({},nv,{scale:"x"}),An({},nv,{scale:"y"})]},sv={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Ov,alpha:1,points:{show:nR,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function iR(n,e,t,i,s){return t/10}var Bv={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},sR=An({},Bv,{time:!1,ori:1}),rv={};function kv(n,e){let t=rv[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(rv[n]=t)),t}var ta=1,cp=2;function Zr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,p=a.top,g=a.width,y=a.height,d=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,f,d,m,h,p,g,y,wh,ia,Ah,Gv,Hv):t(s,l,c,u,f,m,d,p,h,y,g,Eh,sa,Ep,Vv,Wv)}function bp(n,e){let t=0,i=0,s=bt(n.bands,xp);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function rR(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Vs(n,e,t,i,s,r){return Zr(n,e,(o,a,l,c,u,f,h,p,g,y,d)=>{let m=o.pxRound,v=c.dir*(c.ori==0?1:-1),T=c.ori==0?ia:sa,S,C;v==1?(S=t,C=i):(S=i,C=t);let A=m(f(a[S],c,y,p)),_=m(h(l[S],u,d,g)),w=m(f(a[C],c,y,p)),U=m(h(r==1?u.max:u.min,u,d,g)),L=new Path2D(s);return T(L,w,U),T(L,A,U),T(L,A,_),L})}function bh(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Ah:Ep,l=t;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let p=h[0]-l;p>0&&a(o,l,i,p,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function oR(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function wp(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let p=r(n[f]),g=h==f?p:r(n[h]),y=f-s;p=o<=0&&y>=0&&y<l?r(n[y]):p;let m=h+s;g=o>=0&&m>=0&&m<l?r(n[m]):g,g>=p&&a.push([p,g])}return a}function ov(n){return n==0?gv:n==1?In:e=>Wr(e,n)}function zv(n){let e=n==0?wh:Eh,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=ts(c,a/2,l/2),u=ts(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var wh=(n,e,t)=>{n.moveTo(e,t)},Eh=(n,e,t)=>{n.moveTo(t,e)},ia=(n,e,t)=>{n.lineTo(e,t)},sa=(n,e,t)=>{n.lineTo(t,e)},Ah=zv(0),Ep=zv(1),Gv=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Vv=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Hv=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Wv=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Xv(n){return(e,t,i,s,r)=>Zr(e,t,(o,a,l,c,u,f,h,p,g,y,d)=>{let{pxRound:m,points:v}=o,T,S;c.ori==0?(T=wh,S=Gv):(T=Eh,S=Vv);let C=kt(v.width*At,3),A=(v.size-v.width)/2*At,_=kt(A*2,3),w=new Path2D,U=new Path2D,{left:L,top:I,width:k,height:W}=e.bbox;Ah(U,L-_,I-_,k+_*2,W+_*2);let N=V=>{if(l[V]!=null){let Y=m(f(a[V],c,y,p)),G=m(h(l[V],u,d,g));T(w,Y+A,G),S(w,Y,G,A,0,mh*2)}};if(r)r.forEach(N);else for(let V=i;V<=s;V++)N(V);return{stroke:C>0?w:null,fill:w,clip:U,flags:ta|cp}})}function qv(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var aR=qv(ia),lR=qv(sa);function Yv(n){let e=bt(n?.alignGaps,0);return(t,i,s,r)=>Zr(t,i,(o,a,l,c,u,f,h,p,g,y,d)=>{[s,r]=vh(l,s,r);let m=o.pxRound,v=W=>m(f(W,c,y,p)),T=W=>m(h(W,u,d,g)),S,C;c.ori==0?(S=ia,C=aR):(S=sa,C=lR);let A=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ta},w=_.stroke,U=!1;if(r-s>=y*4){let W=he=>t.posToVal(he,c.key,!0),N=null,V=null,Y,G,ae,q=v(a[A==1?s:r]),K=v(a[s]),ne=v(a[r]),ue=W(A==1?K+1:ne-1);for(let he=A==1?s:r;he>=s&&he<=r;he+=A){let Q=a[he],xe=(A==1?Q<ue:Q>ue)?q:v(Q),Ce=l[he];xe==q?Ce!=null?(G=Ce,N==null?(S(w,xe,T(G)),Y=N=V=G):G<N?N=G:G>V&&(V=G)):Ce===null&&(U=!0):(N!=null&&C(w,q,T(N),T(V),T(Y),T(G)),Ce!=null?(G=Ce,S(w,xe,T(G)),N=V=Y=G):(N=V=null,Ce===null&&(U=!0)),q=xe,ue=W(q+A))}N!=null&&N!=V&&ae!=q&&C(w,q,T(N),T(V),T(Y),T(G))}else for(let W=A==1?s:r;W>=s&&W<=r;W+=A){let N=l[W];N===null?U=!0:N!=null&&S(w,v(a[W]),T(N))}let[I,k]=bp(t,i);if(o.fill!=null||I!=0){let W=_.fill=new Path2D(w),N=o.fillTo(t,i,o.min,o.max,I),V=T(N),Y=v(a[s]),G=v(a[r]);A==-1&&([G,Y]=[Y,G]),S(W,G,V),S(W,Y,V)}if(!o.spanGaps){let W=[];U&&W.push(...wp(a,l,s,r,A,v,e)),_.gaps=W=o.gaps(t,i,s,r,W),_.clip=bh(W,c.ori,p,g,y,d)}return k!=0&&(_.band=k==2?[Vs(t,i,s,r,w,-1),Vs(t,i,s,r,w,1)]:Vs(t,i,s,r,w,k)),_})}function cR(n){let e=bt(n.align,1),t=bt(n.ascDesc,!1),i=bt(n.alignGaps,0),s=bt(n.extend,!1);return(r,o,a,l)=>Zr(r,o,(c,u,f,h,p,g,y,d,m,v,T)=>{[a,l]=vh(f,a,l);let S=c.pxRound,{left:C,width:A}=r.bbox,_=K=>S(g(K,h,v,d)),w=K=>S(y(K,p,T,m)),U=h.ori==0?ia:sa,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ta},I=L.stroke,k=h.dir*(h.ori==0?1:-1),W=w(f[k==1?a:l]),N=_(u[k==1?a:l]),V=N,Y=N;s&&e==-1&&(Y=C,U(I,Y,W)),U(I,N,W);for(let K=k==1?a:l;K>=a&&K<=l;K+=k){let ne=f[K];if(ne==null)continue;let ue=_(u[K]),he=w(ne);e==1?U(I,ue,W):U(I,V,he),U(I,ue,he),W=he,V=ue}let G=V;s&&e==1&&(G=C+A,U(I,G,W));let[ae,q]=bp(r,o);if(c.fill!=null||ae!=0){let K=L.fill=new Path2D(I),ne=c.fillTo(r,o,c.min,c.max,ae),ue=w(ne);U(K,G,ue),U(K,Y,ue)}if(!c.spanGaps){let K=[];K.push(...wp(u,f,a,l,k,_,i));let ne=c.width*At/2,ue=t||e==1?ne:-ne,he=t||e==-1?-ne:ne;K.forEach(Q=>{Q[0]+=ue,Q[1]+=he}),L.gaps=K=c.gaps(r,o,a,l,K),L.clip=bh(K,h.ori,d,m,v,T)}return q!=0&&(L.band=q==2?[Vs(r,o,a,l,I,-1),Vs(r,o,a,l,I,1)]:Vs(r,o,a,l,I,q)),L})}function av(n,e,t,i,s,r,o=Bt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Ln(n[l]-n[a]);u<c&&(c=u,o=Ln(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function uR(n){n=n||Dl;let e=bt(n.size,[.6,Bt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=bt(e[1],Bt),l=bt(e[2],1),c=bt(n.disp,Dl),u=bt(n.each,p=>{}),{fill:f,stroke:h}=c;return(p,g,y,d)=>Zr(p,g,(m,v,T,S,C,A,_,w,U,L,I)=>{let k=m.pxRound,W=t,N=i*At,V=a*At,Y=l*At,G,ae;S.ori==0?[G,ae]=r(p,g):[ae,G]=r(p,g);let q=S.dir*(S.ori==0?1:-1),K=S.ori==0?Ah:Ep,ne=S.ori==0?u:(Pe,$e,ot,we,Ot,Ge,Ye)=>{u(Pe,$e,ot,Ot,we,Ye,Ge)},ue=bt(p.bands,xp).find(Pe=>Pe.series[0]==g),he=ue!=null?ue.dir:0,Q=m.fillTo(p,g,m.min,m.max,he),me=k(_(Q,C,I,U)),xe,Ce,be,We=L,rt=k(m.width*At),Ve=!1,ft=null,ct=null,it=null,Kt=null;f!=null&&(rt==0||h!=null)&&(Ve=!0,ft=f.values(p,g,y,d),ct=new Map,new Set(ft).forEach(Pe=>{Pe!=null&&ct.set(Pe,new Path2D)}),rt>0&&(it=h.values(p,g,y,d),Kt=new Map,new Set(it).forEach(Pe=>{Pe!=null&&Kt.set(Pe,new Path2D)})));let{x0:Vt,size:xn}=c;if(Vt!=null&&xn!=null){W=1,v=Vt.values(p,g,y,d),Vt.unit==2&&(v=v.map(ot=>p.posToVal(w+ot*L,S.key,!0)));let Pe=xn.values(p,g,y,d);xn.unit==2?Ce=Pe[0]*L:Ce=A(Pe[0],S,L,w)-A(0,S,L,w),We=av(v,T,A,S,L,w,We),be=We-Ce+N}else We=av(v,T,A,S,L,w,We),be=We*o+N,Ce=We-be;be<1&&(be=0),rt>=Ce/2&&(rt=0),be<5&&(k=gv);let Ut=be>0,Nn=We-be-(Ut?rt:0);Ce=k(op(Nn,Y,V)),xe=(W==0?Ce/2:W==q?0:Ce)-W*q*((W==0?N/2:0)+(Ut?rt/2:0));let St={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Tn=Ve?null:new Path2D,sn=null;if(ue!=null)sn=p.data[ue.series[1]];else{let{y0:Pe,y1:$e}=c;Pe!=null&&$e!=null&&(T=$e.values(p,g,y,d),sn=Pe.values(p,g,y,d))}let vn=G*Ce,O=ae*Ce;for(let Pe=q==1?y:d;Pe>=y&&Pe<=d;Pe+=q){let $e=T[Pe];if($e==null)continue;if(sn!=null){let X=sn[Pe]??0;if($e-X==0)continue;me=_(X,C,I,U)}let ot=S.distr!=2||c!=null?v[Pe]:Pe,we=A(ot,S,L,w),Ot=_(bt($e,Q),C,I,U),Ge=k(we-xe),Ye=k(ri(Ot,me)),R=k(ts(Ot,me)),M=Ye-R;if($e!=null){let X=$e<0?O:vn,ce=$e<0?vn:O;Ve?(rt>0&&it[Pe]!=null&&K(Kt.get(it[Pe]),Ge,R+wi(rt/2),Ce,ri(0,M-rt),X,ce),ft[Pe]!=null&&K(ct.get(ft[Pe]),Ge,R+wi(rt/2),Ce,ri(0,M-rt),X,ce)):K(Tn,Ge,R+wi(rt/2),Ce,ri(0,M-rt),X,ce),ne(p,g,Pe,Ge-rt/2,R,Ce+rt,M)}}return rt>0?St.stroke=Ve?Kt:Tn:Ve||(St._fill=m.width==0?m._fill:m._stroke??m._fill,St.width=0),St.fill=Ve?ct:Tn,St})}function hR(n,e){let t=bt(e?.alignGaps,0);return(i,s,r,o)=>Zr(i,s,(a,l,c,u,f,h,p,g,y,d,m)=>{[r,o]=vh(c,r,o);let v=a.pxRound,T=G=>v(h(G,u,d,g)),S=G=>v(p(G,f,m,y)),C,A,_;u.ori==0?(C=wh,_=ia,A=Hv):(C=Eh,_=sa,A=Wv);let w=u.dir*(u.ori==0?1:-1),U=T(l[w==1?r:o]),L=U,I=[],k=[];for(let G=w==1?r:o;G>=r&&G<=o;G+=w)if(c[G]!=null){let q=l[G],K=T(q);I.push(L=K),k.push(S(c[G]))}let W={stroke:n(I,k,C,_,A,v),fill:null,clip:null,band:null,gaps:null,flags:ta},N=W.stroke,[V,Y]=bp(i,s);if(a.fill!=null||V!=0){let G=W.fill=new Path2D(N),ae=a.fillTo(i,s,a.min,a.max,V),q=S(ae);_(G,L,q),_(G,U,q)}if(!a.spanGaps){let G=[];G.push(...wp(l,c,r,o,w,T,t)),W.gaps=G=a.gaps(i,s,r,o,G),W.clip=bh(G,u.ori,g,y,d,m)}return Y!=0&&(W.band=Y==2?[Vs(i,s,r,o,N,-1),Vs(i,s,r,o,N,1)]:Vs(i,s,r,o,N,Y)),W})}function fR(n){return hR(dR,n)}function dR(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,e[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,n[h+1],e[h+1])}return a}var up=new Set;function lv(){for(let n of up)n.syncRect(!0)}na&&(Yr(YT,jo,lv),Yr($T,jo,lv,!0),Yr(gh,jo,()=>{Gn.pxRatio=At}));var pR=Yv(),mR=Xv();function cv(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>hp(r,o,e,t))}function gR(n,e){return n.map((t,i)=>i==0?{}:An({},e,t))}function hp(n,e,t,i){return An({},e==0?t:i,n)}function $v(n,e,t){return e==null?Qo:[e,t]}var _R=$v;function xR(n,e,t){return e==null?Qo:_h(e,t,gp,!0)}function Zv(n,e,t,i){return e==null?Qo:yh(e,t,n.scales[i].log,!1)}var vR=Zv;function Jv(n,e,t,i){return e==null?Qo:mp(e,t,n.scales[i].log,!1)}var yR=Jv;function SR(n,e,t,i,s){let r=ri(Gx(n),Gx(e)),o=e-n,a=es(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?xr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function uv(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=In((t=+s)*At))+"px"),[n,e,t]}function MR(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=kt(e[2]*At,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Gn(n,e,t){let i={mode:bt(n.mode,1)},s=i.mode;function r(x,b,P,D){let H=b.valToPct(x);return D+P*(b.dir==-1?1-H:H)}function o(x,b,P,D){let H=b.valToPct(x);return D+P*(b.dir==-1?H:1-H)}function a(x,b,P,D){return b.ori==0?r(x,b,P,D):o(x,b,P,D)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Di(RT);if(n.id!=null&&(c.id=n.id),bi(c,n.class),n.title){let x=Di(LT,c);x.textContent=n.title}let u=Qi("canvas"),f=i.ctx=u.getContext("2d"),h=Di(NT,c);Yr("click",h,x=>{x.target===g&&(Yt!=oo||Qt!=ao)&&zn.click(i,x)},!0);let p=i.under=Di(DT,h);h.appendChild(u);let g=i.over=Di(UT,h);n=ea(n);let y=+bt(n.pxAlign,1),d=ov(y);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let m=n.ms||.001,v=i.series=s==1?cv(n.series||[],Qx,sv,!1):gR(n.series||[null],iv),T=i.axes=cv(n.axes||[],Kx,tv,!0),S=i.scales={},C=i.bands=n.bands||[];C.forEach(x=>{x.fill=vt(x.fill||null),x.dir=bt(x.dir,-1)});let A=s==2?v[1].facets[0].scale:v[0].scale,_={axes:bs,series:pt},w=(n.drawOrder||["axes","series"]).map(x=>_[x]);function U(x){let b=x.distr==3?P=>Gs(P>0?P:x.clamp(i,P,x.min,x.max,x.key)):x.distr==4?P=>Kd(P,x.asinh):x.distr==100?P=>x.fwd(P):P=>P;return P=>{let D=b(P),{_min:H,_max:J}=x,oe=J-H;return(D-H)/oe}}function L(x){let b=S[x];if(b==null){let P=(n.scales||Dl)[x]||Dl;if(P.from!=null){L(P.from);let D=An({},S[P.from],P,{key:x});D.valToPct=U(D),S[x]=D}else{b=S[x]=An({},x==A?Bv:sR,P),b.key=x;let D=b.time,H=b.range,J=_r(H);if((x!=A||s==2&&!D)&&(J&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?Bx:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?Bx:{mode:1,hard:H[1],soft:H[1]}},J=!1),!J&&Mh(H))){let oe=H;H=(de,ye,De)=>ye==null?Qo:_h(ye,De,oe)}b.range=vt(H||(D?_R:x==A?b.distr==3?vR:b.distr==4?yR:$v:b.distr==3?Zv:b.distr==4?Jv:xR)),b.auto=vt(J?!1:b.auto),b.clamp=vt(b.clamp||iR),b._min=b._max=null,b.valToPct=U(b)}}}L("x"),L("y"),s==1&&v.forEach(x=>{L(x.scale)}),T.forEach(x=>{L(x.scale)});for(let x in n.scales)L(x);let I=S[A],k=I.distr,W,N;I.ori==0?(bi(c,PT),W=r,N=o):(bi(c,IT),W=o,N=r);let V={};for(let x in S){let b=S[x];(b.min!=null||b.max!=null)&&(V[x]={min:b.min,max:b.max},b.min=b.max=null)}let Y=n.tzDate||(x=>new Date(In(x/m))),G=n.fmtDate||vp,ae=m==1?PC(Y):NC(Y),q=Zx(Y,$x(m==1?RC:LC,G)),K=jx(Y,Jx(UC,G)),ne=[],ue=i.legend=An({},BC,n.legend),he=i.cursor=An({},WC,{drag:{y:s==2}},n.cursor),Q=ue.show,me=he.show,xe=ue.markers;ue.idxs=ne,xe.width=vt(xe.width),xe.dash=vt(xe.dash),xe.stroke=vt(xe.stroke),xe.fill=vt(xe.fill);let Ce,be,We,rt=[],Ve=[],ft,ct=!1,it={};if(ue.live){let x=v[1]?v[1].values:null;ct=x!=null,ft=ct?x(i,1,0):{_:0};for(let b in ft)it[b]=dp}if(Q)if(Ce=Qi("table",GT,c),We=Qi("tbody",null,Ce),ue.mount(i,Ce),ct){be=Qi("thead",null,Ce,We);let x=Qi("tr",null,be);Qi("th",null,x);for(var Kt in ft)Qi("th",Ex,x).textContent=Kt}else bi(Ce,HT),ue.live&&bi(Ce,VT);let Vt={show:!0},xn={show:!1};function Ut(x,b){if(b==0&&(ct||!ue.live||s==2))return Qo;let P=[],D=Qi("tr",WT,We,We.childNodes[b]);bi(D,x.class),x.show||bi(D,qr);let H=Qi("th",null,D);if(xe.show){let de=Di(XT,H);if(b>0){let ye=xe.width(i,b);ye&&(de.style.border=ye+"px "+xe.dash(i,b)+" "+xe.stroke(i,b)),de.style.background=xe.fill(i,b)}}let J=Di(Ex,H);x.label instanceof HTMLElement?J.appendChild(x.label):J.textContent=x.label,b>0&&(xe.show||(J.style.color=x.width>0?xe.stroke(i,b):xe.fill(i,b)),St("click",H,de=>{if(he._lock)return;je(de);let ye=v.indexOf(x);if((de.ctrlKey||de.metaKey)!=ue.isolate){let De=v.some((Ue,Oe)=>Oe>0&&Oe!=ye&&Ue.show);v.forEach((Ue,Oe)=>{Oe>0&&os(Oe,De?Oe==ye?Vt:xn:Vt,!0,bn.setSeries)})}else os(ye,{show:!x.show},!0,bn.setSeries)},!1),Ke&&St(Rx,H,de=>{he._lock||(je(de),os(v.indexOf(x),co,!0,bn.setSeries))},!1));for(var oe in ft){let de=Qi("td",qT,D);de.textContent="--",P.push(de)}return[D,P]}let Nn=new Map;function St(x,b,P,D=!0){let H=Nn.get(b)||{},J=he.bind[x](i,b,P,D);J&&(Yr(x,b,H[x]=J),Nn.set(b,H))}function Tn(x,b,P){let D=Nn.get(b)||{};for(let H in D)(x==null||H==x)&&(rp(H,b,D[H]),delete D[H]);x==null&&Nn.delete(b)}let sn=0,vn=0,O=0,Pe=0,$e=0,ot=0,we=$e,Ot=ot,Ge=O,Ye=Pe,R=0,M=0,X=0,ce=0;i.bbox={};let re=!1,_e=!1,ve=!1,ee=!1,ie=!1,pe=!1;function F(x,b,P){(P||x!=i.width||b!=i.height)&&se(x,b),ut(!1),ve=!0,_e=!0,Vn()}function se(x,b){i.width=sn=O=x,i.height=vn=Pe=b,$e=ot=0,Se(),He();let P=i.bbox;R=P.left=Wr($e*At,.5),M=P.top=Wr(ot*At,.5),X=P.width=Wr(O*At,.5),ce=P.height=Wr(Pe*At,.5)}let te=3;function Ee(){let x=!1,b=0;for(;!x;){b++;let P=io(b),D=rs(b);x=b==te||P&&D,x||(se(i.width,i.height),_e=!0)}}function ge({width:x,height:b}){F(x,b)}i.setSize=ge;function Se(){let x=!1,b=!1,P=!1,D=!1;T.forEach((H,J)=>{if(H.show&&H._show){let{side:oe,_size:de}=H,ye=oe%2,De=H.label!=null?H.labelSize:0,Ue=de+De;Ue>0&&(ye?(O-=Ue,oe==3?($e+=Ue,D=!0):P=!0):(Pe-=Ue,oe==0?(ot+=Ue,x=!0):b=!0))}}),is[0]=x,is[1]=P,is[2]=b,is[3]=D,O-=Bi[1]+Bi[3],$e+=Bi[3],Pe-=Bi[2]+Bi[0],ot+=Bi[0]}function He(){let x=$e+O,b=ot+Pe,P=$e,D=ot;function H(J,oe){switch(J){case 1:return x+=oe,x-oe;case 2:return b+=oe,b-oe;case 3:return P-=oe,P+oe;case 0:return D-=oe,D+oe}}T.forEach((J,oe)=>{if(J.show&&J._show){let de=J.side;J._pos=H(de,J._size),J.label!=null&&(J._lpos=H(de,J.labelSize))}})}if(he.dataIdx==null){let x=he.hover,b=x.skip=new Set(x.skip??[]);b.add(void 0);let P=x.prox=vt(x.prox),D=x.bias??=0;he.dataIdx=(H,J,oe,de)=>{if(J==0)return oe;let ye=oe,De=P(H,J,oe,de)??Bt,Ue=De>=0&&De<Bt,Oe=I.ori==0?O:Pe,st=he.left,wt=e[0],Mt=e[J];if(b.has(Mt[oe])){ye=null;let mt=null,Je=null,Xe;if(D==0||D==-1)for(Xe=oe;mt==null&&Xe-- >0;)b.has(Mt[Xe])||(mt=Xe);if(D==0||D==1)for(Xe=oe;Je==null&&Xe++<Mt.length;)b.has(Mt[Xe])||(Je=Xe);if(mt!=null||Je!=null)if(Ue){let Zt=mt==null?-1/0:W(wt[mt],I,Oe,0),an=Je==null?1/0:W(wt[Je],I,Oe,0),On=st-Zt,Ft=an-st;On<=Ft?On<=De&&(ye=mt):Ft<=De&&(ye=Je)}else ye=Je==null?mt:mt==null?Je:oe-mt<=Je-oe?mt:Je}else Ue&&Ln(st-W(wt[oe],I,Oe,0))>De&&(ye=null);return ye}}let je=x=>{he.event=x};he.idxs=ne,he._lock=!1;let le=he.points;le.show=vt(le.show),le.size=vt(le.size),le.stroke=vt(le.stroke),le.width=vt(le.width),le.fill=vt(le.fill);let Be=i.focus=An({},n.focus||{alpha:.3},he.focus),Ke=Be.prox>=0,Re=Ke&&le.one,at=[],qt=[],Zn=[];function ua(x,b){let P=le.show(i,b);if(P instanceof HTMLElement)return bi(P,zT),bi(P,x.class),_s(P,-10,-10,O,Pe),g.insertBefore(P,at[b]),P}function eo(x,b){if(s==1||b>0){let P=s==1&&S[x.scale].time,D=x.value;x.value=P?Wx(D)?jx(Y,Jx(D,G)):D||K:D||eR,x.label=x.label||(P?qC:XC)}if(Re||b>0){x.width=x.width==null?1:x.width,x.paths=x.paths||pR||sC,x.fillTo=vt(x.fillTo||rR),x.pxAlign=+bt(x.pxAlign,y),x.pxRound=ov(x.pxAlign),x.stroke=vt(x.stroke||null),x.fill=vt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let P=tR(ri(1,x.width),1),D=x.points=An({},{size:P,width:ri(1,P*.2),stroke:x.stroke,space:P*2,paths:mR,_stroke:null,_fill:null},x.points);D.show=vt(D.show),D.filter=vt(D.filter),D.fill=vt(D.fill),D.stroke=vt(D.stroke),D.paths=vt(D.paths),D.pxAlign=x.pxAlign}if(Q){let P=Ut(x,b);rt.splice(b,0,P[0]),Ve.splice(b,0,P[1]),ue.values.push(null)}if(me){ne.splice(b,0,null);let P=null;Re?b==0&&(P=ua(x,b)):b>0&&(P=ua(x,b)),at.splice(b,0,P),qt.splice(b,0,0),Zn.splice(b,0,0)}Fn("addSeries",b)}function zh(x,b){b=b??v.length,x=s==1?hp(x,b,Qx,sv):hp(x,b,{},iv),v.splice(b,0,x),eo(v[b],b)}i.addSeries=zh;function ql(x){if(v.splice(x,1),Q){ue.values.splice(x,1),Ve.splice(x,1);let b=rt.splice(x,1)[0];Tn(null,b.firstChild),b.remove()}me&&(ne.splice(x,1),at.splice(x,1)[0].remove(),qt.splice(x,1),Zn.splice(x,1)),Fn("delSeries",x)}i.delSeries=ql;let is=[!1,!1,!1,!1];function ys(x,b){if(x._show=x.show,x.show){let P=x.side%2,D=S[x.scale];D==null&&(x.scale=P?v[1].scale:A,D=S[x.scale]);let H=D.time;x.size=vt(x.size),x.space=vt(x.space),x.rotate=vt(x.rotate),_r(x.incrs)&&x.incrs.forEach(oe=>{!xr.has(oe)&&xr.set(oe,vv(oe))}),x.incrs=vt(x.incrs||(D.distr==2?AC:H?m==1?CC:IC:Xr)),x.splits=vt(x.splits||(H&&D.distr==1?ae:D.distr==3?ap:D.distr==4?ZC:$C)),x.stroke=vt(x.stroke),x.grid.stroke=vt(x.grid.stroke),x.ticks.stroke=vt(x.ticks.stroke),x.border.stroke=vt(x.border.stroke);let J=x.values;x.values=_r(J)&&!_r(J[0])?vt(J):H?_r(J)?Zx(Y,$x(J,G)):Wx(J)?DC(Y,J):J||q:J||YC,x.filter=vt(x.filter||(D.distr>=3&&D.log==10?KC:D.distr==3&&D.log==2?QC:_v)),x.font=uv(x.font),x.labelFont=uv(x.labelFont),x._size=x.size(i,null,b,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(is[b]=!0,x._el=Di(FT,h))}}function Ss(x,b,P,D){let[H,J,oe,de]=P,ye=b%2,De=0;return ye==0&&(de||J)&&(De=b==0&&!H||b==2&&!oe?In(Kx.size/3):0),ye==1&&(H||oe)&&(De=b==1&&!J||b==3&&!de?In(tv.size/2):0),De}let ha=i.padding=(n.padding||[Ss,Ss,Ss,Ss]).map(x=>vt(bt(x,Ss))),Bi=i._padding=ha.map((x,b)=>x(i,b,is,0)),rn,dn=null,pn=null,ss=s==1?v[0].idxs:null,di=null,qs=!1;function fa(x,b){if(e=x??[],i.data=i._data=e,s==2){rn=0;for(let P=1;P<v.length;P++)rn+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),di=e[0],rn=di.length;let P=e;if(k==2){P=e.slice();let D=P[0]=Array(rn);for(let H=0;H<rn;H++)D[H]=H}i._data=e=P}if(ut(!0),Fn("setData"),k==2&&(ve=!0),b!==!1){let P=I;P.auto(i,qs)?da():Zs(A,P.min,P.max),ee=ee||he.left>=0,pe=!0,Vn()}}i.setData=fa;function da(){qs=!0;let x,b;s==1&&(rn>0?(dn=ss[0]=0,pn=ss[1]=rn-1,x=e[0][dn],b=e[0][pn],k==2?(x=dn,b=pn):x==b&&(k==3?[x,b]=yh(x,x,I.log,!1):k==4?[x,b]=mp(x,x,I.log,!1):I.time?b=x+In(86400/m):[x,b]=_h(x,b,gp,!0))):(dn=ss[0]=x=null,pn=ss[1]=b=null)),Zs(A,x,b)}let to,Ys,no,E,z,j,$,Z,Ae,Ie;function Te(x,b,P,D,H,J){x??=Tx,P??=xp,D??="butt",H??=Tx,J??="round",x!=to&&(f.strokeStyle=to=x),H!=Ys&&(f.fillStyle=Ys=H),b!=no&&(f.lineWidth=no=b),J!=z&&(f.lineJoin=z=J),D!=j&&(f.lineCap=j=D),P!=E&&f.setLineDash(E=P)}function Le(x,b,P,D){b!=Ys&&(f.fillStyle=Ys=b),x!=$&&(f.font=$=x),P!=Z&&(f.textAlign=Z=P),D!=Ae&&(f.textBaseline=Ae=D)}function ze(x,b,P,D,H=0){if(D.length>0&&x.auto(i,qs)&&(b==null||b.min==null)){let J=bt(dn,0),oe=bt(pn,D.length-1),de=P.min==null?KT(D,J,oe,H,x.distr==3):[P.min,P.max];x.min=ts(x.min,P.min=de[0]),x.max=ri(x.max,P.max=de[1])}}let et={min:null,max:null};function dt(){for(let D in S){let H=S[D];V[D]==null&&(H.min==null||V[A]!=null&&H.auto(i,qs))&&(V[D]=et)}for(let D in S){let H=S[D];V[D]==null&&H.from!=null&&V[H.from]!=null&&(V[D]=et)}V[A]!=null&&ut(!0);let x={};for(let D in V){let H=V[D];if(H!=null){let J=x[D]=ea(S[D],aC);if(H.min!=null)An(J,H);else if(D!=A||s==2)if(rn==0&&J.from==null){let oe=J.range(i,null,null,D);J.min=oe[0],J.max=oe[1]}else J.min=Bt,J.max=-Bt}}if(rn>0){v.forEach((D,H)=>{if(s==1){let J=D.scale,oe=V[J];if(oe==null)return;let de=x[J];if(H==0){let ye=de.range(i,de.min,de.max,J);de.min=ye[0],de.max=ye[1],dn=es(de.min,e[0]),pn=es(de.max,e[0]),pn-dn>1&&(e[0][dn]<de.min&&dn++,e[0][pn]>de.max&&pn--),D.min=di[dn],D.max=di[pn]}else D.show&&D.auto&&ze(de,oe,D,e[H],D.sorted);D.idxs[0]=dn,D.idxs[1]=pn}else if(H>0&&D.show&&D.auto){let[J,oe]=D.facets,de=J.scale,ye=oe.scale,[De,Ue]=e[H],Oe=x[de],st=x[ye];Oe!=null&&ze(Oe,V[de],J,De,J.sorted),st!=null&&ze(st,V[ye],oe,Ue,oe.sorted),D.min=oe.min,D.max=oe.max}});for(let D in x){let H=x[D],J=V[D];if(H.from==null&&(J==null||J.min==null)){let oe=H.range(i,H.min==Bt?null:H.min,H.max==-Bt?null:H.max,D);H.min=oe[0],H.max=oe[1]}}}for(let D in x){let H=x[D];if(H.from!=null){let J=x[H.from];if(J.min==null)H.min=H.max=null;else{let oe=H.range(i,J.min,J.max,D);H.min=oe[0],H.max=oe[1]}}}let b={},P=!1;for(let D in x){let H=x[D],J=S[D];if(J.min!=H.min||J.max!=H.max){J.min=H.min,J.max=H.max;let oe=J.distr;J._min=oe==3?Gs(J.min):oe==4?Kd(J.min,J.asinh):oe==100?J.fwd(J.min):J.min,J._max=oe==3?Gs(J.max):oe==4?Kd(J.max,J.asinh):oe==100?J.fwd(J.max):J.max,b[D]=P=!0}}if(P){v.forEach((D,H)=>{s==2?H>0&&b.y&&(D._paths=null):b[D.scale]&&(D._paths=null)});for(let D in b)ve=!0,Fn("setScale",D);me&&he.left>=0&&(ee=pe=!0)}for(let D in V)V[D]=null}function ke(x){let b=op(dn-1,0,rn-1),P=op(pn+1,0,rn-1);for(;x[b]==null&&b>0;)b--;for(;x[P]==null&&P<rn-1;)P++;return[b,P]}function pt(){if(rn>0){let x=v.some(b=>b._focus)&&Ie!=Be.alpha;x&&(f.globalAlpha=Ie=Be.alpha),v.forEach((b,P)=>{if(P>0&&b.show&&(nn(P,!1),nn(P,!0),b._paths==null)){let D=Ie;Ie!=b.alpha&&(f.globalAlpha=Ie=b.alpha);let H=s==2?[0,e[P][0].length-1]:ke(e[P]);b._paths=b.paths(i,P,H[0],H[1]),Ie!=D&&(f.globalAlpha=Ie=D)}}),v.forEach((b,P)=>{if(P>0&&b.show){let D=Ie;Ie!=b.alpha&&(f.globalAlpha=Ie=b.alpha),b._paths!=null&&It(P,!1);{let H=b._paths!=null?b._paths.gaps:null,J=b.points.show(i,P,dn,pn,H),oe=b.points.filter(i,P,J,H);(J||oe)&&(b.points._paths=b.points.paths(i,P,dn,pn,oe),It(P,!0))}Ie!=D&&(f.globalAlpha=Ie=D),Fn("drawSeries",P)}}),x&&(f.globalAlpha=Ie=1)}}function nn(x,b){let P=b?v[x].points:v[x];P._stroke=P.stroke(i,x),P._fill=P.fill(i,x)}function It(x,b){let P=b?v[x].points:v[x],{stroke:D,fill:H,clip:J,flags:oe,_stroke:de=P._stroke,_fill:ye=P._fill,_width:De=P.width}=P._paths;De=kt(De*At,3);let Ue=null,Oe=De%2/2;b&&ye==null&&(ye=De>0?"#fff":de);let st=P.pxAlign==1&&Oe>0;if(st&&f.translate(Oe,Oe),!b){let wt=R-De/2,Mt=M-De/2,mt=X+De,Je=ce+De;Ue=new Path2D,Ue.rect(wt,Mt,mt,Je)}b?Fe(de,De,P.dash,P.cap,ye,D,H,oe,J):Lt(x,de,De,P.dash,P.cap,ye,D,H,oe,Ue,J),st&&f.translate(-Oe,-Oe)}function Lt(x,b,P,D,H,J,oe,de,ye,De,Ue){let Oe=!1;ye!=0&&C.forEach((st,wt)=>{if(st.series[0]==x){let Mt=v[st.series[1]],mt=e[st.series[1]],Je=(Mt._paths||Dl).band;_r(Je)&&(Je=st.dir==1?Je[0]:Je[1]);let Xe,Zt=null;Mt.show&&Je&&eC(mt,dn,pn)?(Zt=st.fill(i,wt)||J,Xe=Mt._paths.clip):Je=null,Fe(b,P,D,H,Zt,oe,de,ye,De,Ue,Xe,Je),Oe=!0}}),Oe||Fe(b,P,D,H,J,oe,de,ye,De,Ue)}let Cn=ta|cp;function Fe(x,b,P,D,H,J,oe,de,ye,De,Ue,Oe){Te(x,b,P,D,H),(ye||De||Oe)&&(f.save(),ye&&f.clip(ye),De&&f.clip(De)),Oe?(de&Cn)==Cn?(f.clip(Oe),Ue&&f.clip(Ue),gt(H,oe),yn(x,J,b)):de&cp?(gt(H,oe),f.clip(Oe),yn(x,J,b)):de&ta&&(f.save(),f.clip(Oe),Ue&&f.clip(Ue),gt(H,oe),f.restore(),yn(x,J,b)):(gt(H,oe),yn(x,J,b)),(ye||De||Oe)&&f.restore()}function yn(x,b,P){P>0&&(b instanceof Map?b.forEach((D,H)=>{f.strokeStyle=to=H,f.stroke(D)}):b!=null&&x&&f.stroke(b))}function gt(x,b){b instanceof Map?b.forEach((P,D)=>{f.fillStyle=Ys=D,f.fill(P)}):b!=null&&x&&f.fill(b)}function Ms(x,b,P,D){let H=T[x],J;if(D<=0)J=[0,0];else{let oe=H._space=H.space(i,x,b,P,D),de=H._incrs=H.incrs(i,x,b,P,D,oe);J=SR(b,P,de,D,oe)}return H._found=J}function Sn(x,b,P,D,H,J,oe,de,ye,De){let Ue=oe%2/2;y==1&&f.translate(Ue,Ue),Te(de,oe,ye,De,de),f.beginPath();let Oe,st,wt,Mt,mt=H+(D==0||D==3?-J:J);P==0?(st=H,Mt=mt):(Oe=H,wt=mt);for(let Je=0;Je<x.length;Je++)b[Je]!=null&&(P==0?Oe=wt=x[Je]:st=Mt=x[Je],f.moveTo(Oe,st),f.lineTo(wt,Mt));f.stroke(),y==1&&f.translate(-Ue,-Ue)}function io(x){let b=!0;return T.forEach((P,D)=>{if(!P.show)return;let H=S[P.scale];if(H.min==null){P._show&&(b=!1,P._show=!1,ut(!1));return}else P._show||(b=!1,P._show=!0,ut(!1));let J=P.side,oe=J%2,{min:de,max:ye}=H,[De,Ue]=Ms(D,de,ye,oe==0?O:Pe);if(Ue==0)return;let Oe=H.distr==2,st=P._splits=P.splits(i,D,de,ye,De,Ue,Oe),wt=H.distr==2?st.map(Xe=>di[Xe]):st,Mt=H.distr==2?di[st[1]]-di[st[0]]:De,mt=P._values=P.values(i,P.filter(i,wt,D,Ue,Mt),D,Ue,Mt);P._rotate=J==2?P.rotate(i,mt,D,Ue):0;let Je=P._size;P._size=Ui(P.size(i,mt,D,x)),Je!=null&&P._size!=Je&&(b=!1)}),b}function rs(x){let b=!0;return ha.forEach((P,D)=>{let H=P(i,D,is,x);H!=Bi[D]&&(b=!1),Bi[D]=H}),b}function bs(){for(let x=0;x<T.length;x++){let b=T[x];if(!b.show||!b._show)continue;let P=b.side,D=P%2,H,J,oe=b.stroke(i,x),de=P==0||P==3?-1:1,[ye,De]=b._found;if(b.label!=null){let Kn=b.labelGap*de,gi=In((b._lpos+Kn)*At);Le(b.labelFont[0],oe,"center",P==2?"top":Ax),f.save(),D==1?(H=J=0,f.translate(gi,In(M+ce/2)),f.rotate((P==3?-mh:mh)/2)):(H=In(R+X/2),J=gi);let br=mv(b.label)?b.label(i,x,ye,De):b.label;f.fillText(br,H,J),f.restore()}if(De==0)continue;let Ue=S[b.scale],Oe=D==0?X:ce,st=D==0?R:M,wt=b._splits,Mt=Ue.distr==2?wt.map(Kn=>di[Kn]):wt,mt=Ue.distr==2?di[wt[1]]-di[wt[0]]:ye,Je=b.ticks,Xe=b.border,Zt=Je.show?Je.size:0,an=In(Zt*At),On=In((b.alignTo==2?b._size-Zt-b.gap:b.gap)*At),Ft=b._rotate*-mh/180,ln=d(b._pos*At),pi=(an+On)*de,jn=ln+pi;J=D==0?jn:0,H=D==1?jn:0;let Ai=b.font[0],ki=b.align==1?Zo:b.align==2?Zd:Ft>0?Zo:Ft<0?Zd:D==0?"center":P==3?Zd:Zo,ls=Ft||D==1?"middle":P==2?"top":Ax;Le(Ai,oe,ki,ls);let mi=b.font[1]*b.lineGap,Ti=wt.map(Kn=>d(a(Kn,Ue,Oe,st))),zi=b._values;for(let Kn=0;Kn<zi.length;Kn++){let gi=zi[Kn];if(gi!=null){D==0?H=Ti[Kn]:J=Ti[Kn],gi=""+gi;let br=gi.indexOf(`
`)==-1?[gi]:gi.split(/\n/gm);for(let Qn=0;Qn<br.length;Qn++){let mm=br[Qn];Ft?(f.save(),f.translate(H,J+Qn*mi),f.rotate(Ft),f.fillText(mm,0,0),f.restore()):f.fillText(mm,H,J+Qn*mi)}}}Je.show&&Sn(Ti,Je.filter(i,Mt,x,De,mt),D,P,ln,an,kt(Je.width*At,3),Je.stroke(i,x),Je.dash,Je.cap);let cs=b.grid;cs.show&&Sn(Ti,cs.filter(i,Mt,x,De,mt),D,D==0?2:1,D==0?M:R,D==0?ce:X,kt(cs.width*At,3),cs.stroke(i,x),cs.dash,cs.cap),Xe.show&&Sn([ln],[1],D==0?1:0,D==0?1:2,D==1?M:R,D==1?ce:X,kt(Xe.width*At,3),Xe.stroke(i,x),Xe.dash,Xe.cap)}Fn("drawAxes")}function ut(x){v.forEach((b,P)=>{P>0&&(b._paths=null,x&&(s==1?(b.min=null,b.max=null):b.facets.forEach(D=>{D.min=null,D.max=null})))})}let on=!1,Jn=!1,Nt=[];function Mn(){Jn=!1;for(let x=0;x<Nt.length;x++)Fn(...Nt[x]);Nt.length=0}function Vn(){on||(pC(jp),on=!0)}function Yl(x,b=!1){on=!0,Jn=b,x(i),jp(),b&&Nt.length>0&&queueMicrotask(Mn)}i.batch=Yl;function jp(){if(re&&(dt(),re=!1),ve&&(Ee(),ve=!1),_e){if(jt(p,Zo,$e),jt(p,"top",ot),jt(p,Pl,O),jt(p,Il,Pe),jt(g,Zo,$e),jt(g,"top",ot),jt(g,Pl,O),jt(g,Il,Pe),jt(h,Pl,sn),jt(h,Il,vn),u.width=In(sn*At),u.height=In(vn*At),T.forEach(({_el:x,_show:b,_size:P,_pos:D,side:H})=>{if(x!=null)if(b){let J=H===3||H===0?P:0,oe=H%2==1;jt(x,oe?"left":"top",D-J),jt(x,oe?"width":"height",P),jt(x,oe?"top":"left",oe?ot:$e),jt(x,oe?"height":"width",oe?Pe:O),sp(x,qr)}else bi(x,qr)}),to=Ys=no=z=j=$=Z=Ae=E=null,Ie=1,ga(!0),$e!=we||ot!=Ot||O!=Ge||Pe!=Ye){ut(!1);let x=O/Ge,b=Pe/Ye;if(me&&!ee&&he.left>=0){he.left*=x,he.top*=b,so&&_s(so,In(he.left),0,O,Pe),ro&&_s(ro,0,In(he.top),O,Pe);for(let P=0;P<at.length;P++){let D=at[P];D!=null&&(qt[P]*=x,Zn[P]*=b,_s(D,Ui(qt[P]),Ui(Zn[P]),O,Pe))}}if($t.show&&!ie&&$t.left>=0&&$t.width>0){$t.left*=x,$t.width*=x,$t.top*=b,$t.height*=b;for(let P in qh)jt(lo,P,$t[P])}we=$e,Ot=ot,Ge=O,Ye=Pe}Fn("setSize"),_e=!1}sn>0&&vn>0&&(f.clearRect(0,0,u.width,u.height),Fn("drawClear"),w.forEach(x=>x()),Fn("draw")),$t.show&&ie&&($l($t),ie=!1),me&&ee&&(Mr(null,!0,!1),ee=!1),ue.show&&ue.live&&pe&&(Wh(),pe=!1),l||(l=!0,i.status=1,Fn("ready")),qs=!1,on=!1}i.redraw=(x,b)=>{ve=b||!1,x!==!1?Zs(A,I.min,I.max):Vn()};function Gh(x,b){let P=S[x];if(P.from==null){if(rn==0){let D=P.range(i,b.min,b.max,x);b.min=D[0],b.max=D[1]}if(b.min>b.max){let D=b.min;b.min=b.max,b.max=D}if(rn>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;x==A&&P.distr==2&&rn>0&&(b.min=es(b.min,e[0]),b.max=es(b.max,e[0]),b.min==b.max&&b.max++),V[x]=b,re=!0,Vn()}}i.setScale=Gh;let Vh,Hh,so,ro,Kp,Qp,oo,ao,em,tm,Yt,Qt,$s=!1,zn=he.drag,Dn=zn.x,Un=zn.y;me&&(he.x&&(Vh=Di(BT,g)),he.y&&(Hh=Di(kT,g)),I.ori==0?(so=Vh,ro=Hh):(so=Hh,ro=Vh),Yt=he.left,Qt=he.top);let $t=i.select=An({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),lo=$t.show?Di(OT,$t.over?g:p):null;function $l(x,b){if($t.show){for(let P in x)$t[P]=x[P],P in qh&&jt(lo,P,x[P]);b!==!1&&Fn("setSelect")}}i.setSelect=$l;function kS(x){if(v[x].show)Q&&sp(rt[x],qr);else if(Q&&bi(rt[x],qr),me){let P=Re?at[0]:at[x];P!=null&&_s(P,-10,-10,O,Pe)}}function Zs(x,b,P){Gh(x,{min:b,max:P})}function os(x,b,P,D){b.focus!=null&&WS(x),b.show!=null&&v.forEach((H,J)=>{J>0&&(x==J||x==null)&&(H.show=b.show,kS(J),s==2?(Zs(H.facets[0].scale,null,null),Zs(H.facets[1].scale,null,null)):Zs(H.scale,null,null),Vn())}),P!==!1&&Fn("setSeries",x,b),D&&_a("setSeries",i,x,b)}i.setSeries=os;function zS(x,b){An(C[x],b)}function GS(x,b){x.fill=vt(x.fill||null),x.dir=bt(x.dir,-1),b=b??C.length,C.splice(b,0,x)}function VS(x){x==null?C.length=0:C.splice(x,1)}i.addBand=GS,i.setBand=zS,i.delBand=VS;function HS(x,b){v[x].alpha=b,me&&at[x]!=null&&(at[x].style.opacity=b),Q&&rt[x]&&(rt[x].style.opacity=b)}let ws,Js,Sr,co={focus:!0};function WS(x){if(x!=Sr){let b=x==null,P=Be.alpha!=1;v.forEach((D,H)=>{if(s==1||H>0){let J=b||H==0||H==x;D._focus=b?null:J,P&&HS(H,J?1:Be.alpha)}}),Sr=x,P&&Vn()}}Q&&Ke&&St(Px,Ce,x=>{he._lock||(je(x),Sr!=null&&os(null,co,!0,bn.setSeries))});function as(x,b,P){let D=S[b];P&&(x=x/At-(D.ori==1?ot:$e));let H=O;D.ori==1&&(H=Pe,x=H-x),D.dir==-1&&(x=H-x);let J=D._min,oe=D._max,de=x/H,ye=J+(oe-J)*de,De=D.distr;return De==3?Ko(10,ye):De==4?nC(ye,D.asinh):De==100?D.bwd(ye):ye}function XS(x,b){let P=as(x,A,b);return es(P,e[0],dn,pn)}i.valToIdx=x=>es(x,e[0]),i.posToIdx=XS,i.posToVal=as,i.valToPos=(x,b,P)=>S[b].ori==0?r(x,S[b],P?X:O,P?R:0):o(x,S[b],P?ce:Pe,P?M:0),i.setCursor=(x,b,P)=>{Yt=x.left,Qt=x.top,Mr(null,b,P)};function nm(x,b){jt(lo,Zo,$t.left=x),jt(lo,Pl,$t.width=b)}function im(x,b){jt(lo,"top",$t.top=x),jt(lo,Il,$t.height=b)}let pa=I.ori==0?nm:im,ma=I.ori==1?nm:im;function qS(){if(Q&&ue.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&ct)continue;let b=ue.values[x],P=0;for(let D in b)Ve[x][P++].firstChild.nodeValue=b[D]}}function Wh(x,b){if(x!=null&&(x.idxs?x.idxs.forEach((P,D)=>{ne[D]=P}):oC(x.idx)||ne.fill(x.idx),ue.idx=ne[0]),Q&&ue.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!ct)&&YS(P,ne[P]);qS()}pe=!1,b!==!1&&Fn("setLegend")}i.setLegend=Wh;function YS(x,b){let P=v[x],D=x==0&&k==2?di:e[x],H;ct?H=P.values(i,x,b)??it:(H=P.value(i,b==null?null:D[b],x,b),H=H==null?it:{_:H}),ue.values[x]=H}function Mr(x,b,P){em=Yt,tm=Qt,[Yt,Qt]=he.move(i,Yt,Qt),he.left=Yt,he.top=Qt,me&&(so&&_s(so,In(Yt),0,O,Pe),ro&&_s(ro,0,In(Qt),O,Pe));let D,H=dn>pn;ws=Bt,Js=null;let J=I.ori==0?O:Pe,oe=I.ori==1?O:Pe;if(Yt<0||rn==0||H){D=he.idx=null;for(let de=0;de<v.length;de++){let ye=at[de];ye!=null&&_s(ye,-10,-10,O,Pe)}Ke&&os(null,co,!0,x==null&&bn.setSeries),ue.live&&(ne.fill(D),pe=!0)}else{let de,ye,De;s==1&&(de=I.ori==0?Yt:Qt,ye=as(de,A),D=he.idx=es(ye,e[0],dn,pn),De=W(e[0][D],I,J,0));let Ue=-10,Oe=-10,st=0,wt=0,Mt=!0,mt="",Je="";for(let Xe=s==2?1:0;Xe<v.length;Xe++){let Zt=v[Xe],an=ne[Xe],On=an==null?null:s==1?e[Xe][an]:e[Xe][1][an],Ft=he.dataIdx(i,Xe,D,ye),ln=Ft==null?null:s==1?e[Xe][Ft]:e[Xe][1][Ft];if(pe=pe||ln!=On||Ft!=an,ne[Xe]=Ft,Xe>0&&Zt.show){let pi=Ft==null?-10:Ft==D?De:W(s==1?e[0][Ft]:e[Xe][0][Ft],I,J,0),jn=ln==null?-10:N(ln,s==1?S[Zt.scale]:S[Zt.facets[1].scale],oe,0);if(Ke&&ln!=null){let Ai=I.ori==1?Yt:Qt,ki=Ln(Be.dist(i,Xe,Ft,jn,Ai));if(ki<ws){let ls=Be.bias;if(ls!=0){let mi=as(Ai,Zt.scale),Ti=ln>=0?1:-1,zi=mi>=0?1:-1;zi==Ti&&(zi==1?ls==1?ln>=mi:ln<=mi:ls==1?ln<=mi:ln>=mi)&&(ws=ki,Js=Xe)}else ws=ki,Js=Xe}}if(pe||Re){let Ai,ki;I.ori==0?(Ai=pi,ki=jn):(Ai=jn,ki=pi);let ls,mi,Ti,zi,cs,Kn,gi=!0,br=le.bbox;if(br!=null){gi=!1;let Qn=br(i,Xe);Ti=Qn.left,zi=Qn.top,ls=Qn.width,mi=Qn.height}else Ti=Ai,zi=ki,ls=mi=le.size(i,Xe);if(Kn=le.fill(i,Xe),cs=le.stroke(i,Xe),Re)Xe==Js&&ws<=Be.prox&&(Ue=Ti,Oe=zi,st=ls,wt=mi,Mt=gi,mt=Kn,Je=cs);else{let Qn=at[Xe];Qn!=null&&(qt[Xe]=Ti,Zn[Xe]=zi,Ox(Qn,ls,mi,gi),Ux(Qn,Kn,cs),_s(Qn,Ui(Ti),Ui(zi),O,Pe))}}}}if(Re){let Xe=Be.prox,Zt=Sr==null?ws<=Xe:ws>Xe||Js!=Sr;if(pe||Zt){let an=at[0];an!=null&&(qt[0]=Ue,Zn[0]=Oe,Ox(an,st,wt,Mt),Ux(an,mt,Je),_s(an,Ui(Ue),Ui(Oe),O,Pe))}}}if($t.show&&$s)if(x!=null){let[de,ye]=bn.scales,[De,Ue]=bn.match,[Oe,st]=x.cursor.sync.scales,wt=x.cursor.drag;if(Dn=wt._x,Un=wt._y,Dn||Un){let{left:Mt,top:mt,width:Je,height:Xe}=x.select,Zt=x.scales[Oe].ori,an=x.posToVal,On,Ft,ln,pi,jn,Ai=de!=null&&De(de,Oe),ki=ye!=null&&Ue(ye,st);Ai&&Dn?(Zt==0?(On=Mt,Ft=Je):(On=mt,Ft=Xe),ln=S[de],pi=W(an(On,Oe),ln,J,0),jn=W(an(On+Ft,Oe),ln,J,0),pa(ts(pi,jn),Ln(jn-pi))):pa(0,J),ki&&Un?(Zt==1?(On=Mt,Ft=Je):(On=mt,Ft=Xe),ln=S[ye],pi=N(an(On,st),ln,oe,0),jn=N(an(On+Ft,st),ln,oe,0),ma(ts(pi,jn),Ln(jn-pi))):ma(0,oe)}else Yh()}else{let de=Ln(em-Kp),ye=Ln(tm-Qp);if(I.ori==1){let st=de;de=ye,ye=st}Dn=zn.x&&de>=zn.dist,Un=zn.y&&ye>=zn.dist;let De=zn.uni;De!=null?Dn&&Un&&(Dn=de>=De,Un=ye>=De,!Dn&&!Un&&(ye>de?Un=!0:Dn=!0)):zn.x&&zn.y&&(Dn||Un)&&(Dn=Un=!0);let Ue,Oe;Dn&&(I.ori==0?(Ue=oo,Oe=Yt):(Ue=ao,Oe=Qt),pa(ts(Ue,Oe),Ln(Oe-Ue)),Un||ma(0,oe)),Un&&(I.ori==1?(Ue=oo,Oe=Yt):(Ue=ao,Oe=Qt),ma(ts(Ue,Oe),Ln(Oe-Ue)),Dn||pa(0,J)),!Dn&&!Un&&(pa(0,0),ma(0,0))}if(zn._x=Dn,zn._y=Un,x==null){if(P){if(pm!=null){let[de,ye]=bn.scales;bn.values[0]=de!=null?as(I.ori==0?Yt:Qt,de):null,bn.values[1]=ye!=null?as(I.ori==1?Yt:Qt,ye):null}_a(Jd,i,Yt,Qt,O,Pe,D)}if(Ke){let de=P&&bn.setSeries,ye=Be.prox;Sr==null?ws<=ye&&os(Js,co,!0,de):ws>ye?os(null,co,!0,de):Js!=Sr&&os(Js,co,!0,de)}}pe&&(ue.idx=D,Wh()),b!==!1&&Fn("setCursor")}let js=null;Object.defineProperty(i,"rect",{get(){return js==null&&ga(!1),js}});function ga(x=!1){x?js=null:(js=g.getBoundingClientRect(),Fn("syncRect",js))}function sm(x,b,P,D,H,J,oe){he._lock||$s&&x!=null&&x.movementX==0&&x.movementY==0||(Xh(x,b,P,D,H,J,oe,!1,x!=null),x!=null?Mr(null,!0,!0):Mr(b,!0,!1))}function Xh(x,b,P,D,H,J,oe,de,ye){if(js==null&&ga(!1),je(x),x!=null)P=x.clientX-js.left,D=x.clientY-js.top;else{if(P<0||D<0){Yt=-10,Qt=-10;return}let[De,Ue]=bn.scales,Oe=b.cursor.sync,[st,wt]=Oe.values,[Mt,mt]=Oe.scales,[Je,Xe]=bn.match,Zt=b.axes[0].side%2==1,an=I.ori==0?O:Pe,On=I.ori==1?O:Pe,Ft=Zt?J:H,ln=Zt?H:J,pi=Zt?D:P,jn=Zt?P:D;if(Mt!=null?P=Je(De,Mt)?a(st,S[De],an,0):-10:P=an*(pi/Ft),mt!=null?D=Xe(Ue,mt)?a(wt,S[Ue],On,0):-10:D=On*(jn/ln),I.ori==1){let Ai=P;P=D,D=Ai}}ye&&(b==null||b.cursor.event.type==Jd)&&((P<=1||P>=O-1)&&(P=Wr(P,O)),(D<=1||D>=Pe-1)&&(D=Wr(D,Pe))),de?(Kp=P,Qp=D,[oo,ao]=he.move(i,P,D)):(Yt=P,Qt=D)}let qh={width:0,height:0,left:0,top:0};function Yh(){$l(qh,!1)}let rm,om,am,lm;function cm(x,b,P,D,H,J,oe){$s=!0,Dn=Un=zn._x=zn._y=!1,Xh(x,b,P,D,H,J,oe,!0,!1),x!=null&&(St(jd,np,um,!1),_a(Cx,i,oo,ao,O,Pe,null));let{left:de,top:ye,width:De,height:Ue}=$t;rm=de,om=ye,am=De,lm=Ue}function um(x,b,P,D,H,J,oe){$s=zn._x=zn._y=!1,Xh(x,b,P,D,H,J,oe,!1,!0);let{left:de,top:ye,width:De,height:Ue}=$t,Oe=De>0||Ue>0,st=rm!=de||om!=ye||am!=De||lm!=Ue;if(Oe&&st&&$l($t),zn.setScale&&Oe&&st){let wt=de,Mt=De,mt=ye,Je=Ue;if(I.ori==1&&(wt=ye,Mt=Ue,mt=de,Je=De),Dn&&Zs(A,as(wt,A),as(wt+Mt,A)),Un)for(let Xe in S){let Zt=S[Xe];Xe!=A&&Zt.from==null&&Zt.min!=Bt&&Zs(Xe,as(mt+Je,Xe),as(mt,Xe))}Yh()}else he.lock&&(he._lock=!he._lock,Mr(b,!0,x!=null));x!=null&&(Tn(jd,np),_a(jd,i,Yt,Qt,O,Pe,null))}function $S(x,b,P,D,H,J,oe){if(he._lock)return;je(x);let de=$s;if($s){let ye=!0,De=!0,Ue=10,Oe,st;I.ori==0?(Oe=Dn,st=Un):(Oe=Un,st=Dn),Oe&&st&&(ye=Yt<=Ue||Yt>=O-Ue,De=Qt<=Ue||Qt>=Pe-Ue),Oe&&ye&&(Yt=Yt<oo?0:O),st&&De&&(Qt=Qt<ao?0:Pe),Mr(null,!0,!0),$s=!1}Yt=-10,Qt=-10,ne.fill(null),Mr(null,!0,!0),de&&($s=de)}function hm(x,b,P,D,H,J,oe){he._lock||(je(x),da(),Yh(),x!=null&&_a(Ix,i,Yt,Qt,O,Pe,null))}function fm(){T.forEach(MR),F(i.width,i.height,!0)}Yr(gh,jo,fm);let uo={};uo.mousedown=cm,uo.mousemove=sm,uo.mouseup=um,uo.dblclick=hm,uo.setSeries=(x,b,P,D)=>{let H=bn.match[2];P=H(i,b,P),P!=-1&&os(P,D,!0,!1)},me&&(St(Cx,g,cm),St(Jd,g,sm),St(Rx,g,x=>{je(x),ga(!1)}),St(Px,g,$S),St(Ix,g,hm),up.add(i),i.syncRect=ga);let Zl=i.hooks=n.hooks||{};function Fn(x,b,P){Jn?Nt.push([x,b,P]):x in Zl&&Zl[x].forEach(D=>{D.call(null,i,b,P)})}(n.plugins||[]).forEach(x=>{for(let b in x.hooks)Zl[b]=(Zl[b]||[]).concat(x.hooks[b])});let dm=(x,b,P)=>P,bn=An({key:null,setSeries:!1,filters:{pub:Vx,sub:Vx},scales:[A,v[1]?v[1].scale:null],match:[Hx,Hx,dm],values:[null,null]},he.sync);bn.match.length==2&&bn.match.push(dm),he.sync=bn;let pm=bn.key,$h=kv(pm);function _a(x,b,P,D,H,J,oe){bn.filters.pub(x,b,P,D,H,J,oe)&&$h.pub(x,b,P,D,H,J,oe)}$h.sub(i);function ZS(x,b,P,D,H,J,oe){bn.filters.sub(x,b,P,D,H,J,oe)&&uo[x](null,b,P,D,H,J,oe)}i.pub=ZS;function JS(){$h.unsub(i),up.delete(i),Nn.clear(),rp(gh,jo,fm),c.remove(),Ce?.remove(),Fn("destroy")}i.destroy=JS;function Zh(){Fn("init",n,e),fa(e||n.data,!1),V[A]?Gh(A,V[A]):da(),ie=$t.show&&($t.width>0||$t.height>0),ee=pe=!0,F(n.width,n.height)}return v.forEach(eo),T.forEach(ys),t?t instanceof HTMLElement?(t.appendChild(c),Zh()):t(i,Zh):Zh(),i}Gn.assign=An;Gn.fmtNum=_p;Gn.rangeNum=_h;Gn.rangeLog=yh;Gn.rangeAsinh=mp;Gn.orient=Zr;Gn.pxRatio=At;Gn.join=dC;Gn.fmtDate=vp,Gn.tzDate=wC;Gn.sync=kv;{Gn.addGap=oR,Gn.clipGaps=bh;let n=Gn.paths={points:Xv};n.linear=Yv,n.stepped=cR,n.bars=uR,n.spline=fR}function Ap(n,e=10,t=2500){return{step:e/t,bins:t,used:0,last:-1,base:null,times:new Float64Array(t),values:Object.fromEntries(n.map(s=>[s,new Float64Array(t).fill(NaN)]))}}function Th(n){n.used=0,n.last=-1,n.base=null}function Tp(n,e,t){if(!Number.isFinite(e))return;n.base===null&&(n.base=e);let i=Math.floor((e-n.base)/n.step);if(i<n.last&&(Th(n),n.base=e,i=0),i!==n.last){n.used===n.bins&&bR(n),n.times[n.used]=e;for(let o of Object.values(n.values))o[n.used]=NaN;n.used+=1,n.last=i}let r=n.used-1;for(let[o,a]of Object.entries(t)){let l=n.values[o];!l||!Number.isFinite(a)||Math.abs(l[r])>=Math.abs(a)||(l[r]=a)}}function bR(n){let e=n.bins>>3;n.times.copyWithin(0,e);for(let t of Object.values(n.values))t.copyWithin(0,e);n.used-=e}function Cp(n,e){return[n.times.subarray(0,n.used),...e.map(t=>{let i=new Array(n.used);for(let s=0;s<n.used;s++)i[s]=Number.isNaN(n.values[t][s])?null:n.values[t][s];return i})]}function jv(n,e){let t=Object.keys(e),i=[["time [s]",...t.map(s=>e[s])].join(",")];for(let s=0;s<n.used;s++){let r=t.map(o=>Number.isFinite(n.values[o][s])?n.values[o][s]:"");i.push([n.times[s].toFixed(4),...r].join(","))}return i.join(`
`)+`
`}var ra=10,Rp=56,wR=45,Qv=["force","force_x","force_y","force_z","torque","torque_x","torque_y","torque_z","penetration","stretch","energy","model_age","step_cpu","wake_late"],ER=["haptic_rate","contact_rate"],Kv=["x","y","z"],AR=[{id:"force",title:"Force on the hand",unit:"N",least:.001,lines:["force","force_x","force_y","force_z"],names:["size",...Kv],colours:["force","x","y","z"]},{id:"torque",title:"Torque on the hand",unit:"N m",least:1e-6,lines:["torque","torque_x","torque_y","torque_z"],names:["size",...Kv],colours:["torque","x","y","z"]},{id:"penetration",title:"Penetration, below 0: gap",unit:"m",least:1e-9,lines:["penetration"],names:["depth"],colours:["contact"]},{id:"stretch",title:"Coupling stretch",unit:"m",least:1e-9,lines:["stretch"],names:["stretch"],colours:["hand"]},{id:"rates",title:"Contact and haptic rate",unit:"Hz",least:1,lines:["contact_rate","haptic_rate"],names:["contact","haptic"],colours:["contact","held"],slow:!0},{id:"age",title:"Age of the contact model",unit:"s",least:1e-6,lines:["model_age"],names:["age"],colours:["muted"]},{id:"energy",title:"Energy put in by the hand",unit:"J",least:1e-9,lines:["energy"],names:["energy"],colours:["torque"]}];function ey(n,e,t){let i={pick:t,pointed:null,parent:n,fast:Ap(Qv,ra),slow:Ap(ER,ra,600),plots:[],rows:0,now:0,marks:[],theme:null,floors:{Hz:1e3,s:.001},rested:0},s=Object.assign(document.createElement("div"),{className:"plots-head"});i.moment=Object.assign(document.createElement("span"),{className:"grow moment"}),s.append(i.moment);for(let[r,o,a]of e){let l=Object.assign(document.createElement("button"),{type:"button",textContent:r,title:o});l.setAttribute("aria-label",`${r}: ${o}`),l.addEventListener("click",a),s.append(l)}n.append(s),n.addEventListener("keydown",r=>LR(i,r));for(let r of AR){let o=document.createElement("figure");o.className="plot";let a=document.createElement("figcaption"),l=document.createElement("output"),c=document.createElement("span");c.className="keys",a.append(Object.assign(document.createElement("span"),{textContent:r.title,className:"plot-title"}),c,l);let u=document.createElement("div");u.className="plot-area",o.append(a,u),n.append(o),i.plots.push({spec:r,box:o,area:u,keys:c,value:l,chart:null})}return i}function Ch(n){n.theme=eh();for(let e of n.plots){e.chart?.destroy(),e.keys.replaceChildren(...e.spec.lines.length>1?e.spec.names.map((i,s)=>{let r=Object.assign(document.createElement("i"),{textContent:i});return r.style.setProperty("--tone",Ct(e.spec.colours[s])),r}):[]);let t=e.area.clientWidth||300;e.chart=new Gn(TR(n,e,t),Cp(ty(n,e),e.spec.lines),e.area),e.chart.over.addEventListener("click",()=>{n.pointed&&n.pick(n.pointed.time)})}}var ty=(n,{spec:e})=>e.slow?n.slow:n.fast;function TR(n,{spec:e},t){let i={stroke:Ct("grid"),width:1};return{width:t,height:Rp,legend:{show:!1},cursor:{sync:{key:"thigma"},points:{size:5},drag:{x:!1,y:!1}},padding:[6,6,0,0],scales:{x:{time:!1,range:()=>[n.now-ra,n.now]},y:{range:(r,o,a)=>CR(o,a,Math.max(e.least,n.floors[e.unit]??0))}},axes:[{show:!0,size:4,grid:i,ticks:{show:!1},values:()=>[],space:40},{size:52,grid:i,ticks:{show:!1},space:12,gap:4,font:"10px system-ui, sans-serif",stroke:Ct("muted"),values:(r,o)=>RR(o,e)}],series:[{},...e.lines.map((r,o)=>({stroke:Ct(e.colours[o]),width:o===0||e.slow?1.6:.8,alpha:o===0||e.slow?1:.75,points:{show:!1},spanGaps:!1,fill:o===0&&!e.slow?`${Ct(e.colours[o])}1f`:void 0}))],hooks:{draw:[r=>PR(r,n)]}}}function CR(n,e,t){if(!Number.isFinite(n)||!Number.isFinite(e))return[0,t];let i=Math.min(0,n),s=Math.max(0,e,i+t),r=.1*(s-i);return[i<0?i-r:0,s+r]}function RR(n,e){let t=Math.max(...n.map(Math.abs)),{number:i,unit:s}=_d(t,e.unit,e.least),r=t===0?1:Number(i)/t,o=n.length>3?2:1,a=n.length-1-(n.length-1)%o;return n.map((l,c)=>{if(c%o!==0)return null;let u=Number((l*r).toPrecision(2)).toString();return c===a?`${u} ${s}`:u})}function PR(n,e){let{ctx:t,bbox:i}=n;t.save(),t.lineWidth=1,t.setLineDash([3,3]);for(let{time:s,kind:r}of e.marks){if(s<e.now-ra)continue;let o=n.valToPos(s,"x",!0);t.strokeStyle=Ct(r==="fault"?"bad":"mark"),t.beginPath(),t.moveTo(o,i.top),t.lineTo(o,i.top+i.height),t.stroke()}t.restore()}function ny(n,e,t){n.marks.push({time:e,kind:t}),n.marks=n.marks.filter(i=>i.time>e-ra).slice(-40)}function iy(n,e,t,i){let s=e/i/10;Object.assign(n.floors,{N:s,"N m":.3*s*e,m:.25*t,J:.01*s*e})}function sy(n,e,t){let i=Object.fromEntries(t.map((r,o)=>[r,o])),s=Qv.filter(r=>i[r]!==void 0);for(let r=0;r<e.rows;r++){let o=c=>e.values[r*e.columns+i[c]],a=Object.fromEntries(s.map(c=>[c,o(c)]));a.force=Math.hypot(a.force_x,a.force_y,a.force_z),a.torque=Math.hypot(a.torque_x,a.torque_y,a.torque_z);let l=e.time+o("t");Tp(n.fast,l,a)}n.rows+=e.rows}function ry(n,e,t,i){Tp(n.slow,e,{haptic_rate:t,contact_rate:i})}function oy(n){Th(n.fast),Th(n.slow),n.marks=[]}var IR=1/40;function LR(n,e){let t={ArrowLeft:-1,ArrowRight:1}[e.key];if(!(!t&&e.key!=="Escape"&&e.key!=="Enter"||e.target!==n.parent)){if(e.key==="Enter"){n.pointed&&n.pick(n.pointed.time);return}e.preventDefault();for(let{chart:i}of n.plots){let s=i.over.clientWidth,r=i.cursor.left>=0?i.cursor.left:s,o=t?Math.max(0,Math.min(s-1,r+t*IR*s)):-10;i.setCursor({left:o,top:o<0?-10:.5*Rp},!1,!1)}n.rested=0}}function NR(n){let{chart:e}=n.plots[0],{idx:t,left:i}=e.cursor;if(t==null||!(i>=0)||!(t<n.fast.used))return null;let s=r=>n.fast.values[r][t];return{time:n.fast.times[t],force:s("force"),torque:s("torque"),penetration:s("penetration"),stretch:s("stretch")}}function ay(n,e){let t=performance.now();if(t<n.rested||n.parent.hidden||n.parent.offsetParent===null)return;Object.assign(n,{now:e,pointed:NR(n)});let i=n.pointed?`At ${n.pointed.time.toFixed(2)} s, ${(e-n.pointed.time).toFixed(2)} s ago`:`The last ${ra} s; point at a time to read it`;n.moment.textContent!==i&&(n.moment.textContent=i),n.theme!==eh()&&Ch(n);for(let r of n.plots){let o=Cp(ty(n,r),r.spec.lines),a=r.area.clientWidth;a>0&&a!==r.chart.width&&r.chart.setSize({width:a,height:Rp}),r.chart.setData(o);let l=DR(n,r,o);r.value.textContent=Yn(l(0),r.spec.unit,r.spec.least),[...r.keys.children].forEach((c,u)=>{let f=n.pointed?`${r.spec.names[u]} ${Yn(l(u),r.spec.unit,r.spec.least)}`:r.spec.names[u];c.textContent!==f&&(c.textContent=f)})}let s=performance.now();n.rested=s+Math.max(wR,9*(s-t))}function DR(n,{chart:e},t){let i=e.cursor.left>=0?e.cursor.idx:null;if(i==null)for(i=t[0].length-1;i>0&&t[0][i]>n.now;)i-=1;return s=>i>=0?t[1+s][i]??NaN:NaN}function ly(n,e){let t=devicePixelRatio||1,i=n.plots.map(({spec:u,chart:f})=>({spec:u,canvas:f.root.querySelector("canvas")})),s=i[0].canvas.width,r=Math.round(22*t),o=Math.round(34*t),a=document.createElement("canvas");a.width=s,a.height=o+i.reduce((u,{canvas:f})=>u+r+f.height,0)+r;let l=a.getContext("2d");l.fillStyle=Ct("panel"),l.fillRect(0,0,a.width,a.height),l.fillStyle=Ct("ink"),l.font=`600 ${14*t}px system-ui, sans-serif`,l.fillText(e,10*t,22*t);let c=o;l.font=`${12*t}px system-ui, sans-serif`;for(let{spec:u,canvas:f}of i)l.fillText(u.title,10*t,c+15*t),l.drawImage(f,0,c+r),c+=r+f.height;return a}function cy(n){return jv(n.fast,{force_x:"force x on the hand [N]",force_y:"force y on the hand [N]",force_z:"force z on the hand [N]",torque_x:"torque x on the hand [N m]",torque_y:"torque y on the hand [N m]",torque_z:"torque z on the hand [N m]",penetration:"penetration [m]",stretch:"coupling stretch [m]",energy:"energy put in by the hand [J]",model_age:"age of the contact model [s]"})}var Pp=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"],[1e-12,"p"]];function uy(n,e){let t=Number.isFinite(n)&&n>0?n:2,[i,s]=Pp.find(([r])=>t>=2*r)??Pp[Pp.length-1];return{scale:i,unit:s+e,decimals:Math.max(1,2-Math.floor(Math.log10(t/i)))}}function hy(n,{scale:e,decimals:t}){if(n==null||!Number.isFinite(n))return"–";let i=n/e;return i.toFixed(Math.abs(i)<999.95?t:0)}function fy(n,e,{workspace:t,tolerance:i}){let s=u=>e.find(f=>f.name===u)?.value,r=n?.force>0?n.force:3.3,o=n?.torque>0?n.torque:.1,a=r/(t?.force_scale>0?t.force_scale:1),l=s("coupling_stiffness"),c=s("contact_stiffness");return{force:r,torque:o,stretch:l>0?a/l:10*i,penetration:c>0?Math.max(a/c,i):i}}var dy=(n,e)=>Number.isFinite(n)&&e>0?Math.min(1,Math.abs(n)/e):0;var my=[{id:"force",name:"Force",unit:"N",help:"on the hand, as sent to the device; the bar ends at the limit of device and safety"},{id:"torque",name:"Torque",unit:"N m",help:"on the hand, about the handle; the bar ends at the limit of device and safety"},{id:"penetration",name:"Depth",unit:"m",help:"of the deepest contact: how far the surfaces pass into each other, or the gap between them; forces begin before they touch; the bar ends where the contact gives the largest force, or the tolerance"},{id:"stretch",name:"Stretch",unit:"m",help:"from the hand to where it holds the object: the spring that is felt; the bar ends at the limit of the force"}];function gy(n){let e={parent:n,tiles:{},lines:{}},t=hn("div","tiles");for(let{id:r,name:o,help:a}of my){let l=hn("div",`tile ${r}`);l.title=a;let c=hn("span","number"),u=hn("span","unit"),f=hn("span","name",o),h=hn("i","gauge"),p=hn("span","limit");l.append(f,c,u,h,p),t.append(l),e.tiles[r]={tile:l,title:f,number:c,unit:u,gauge:h,limit:p}}let i=hn("p","situation"),s=hn("ul","lines");for(let r of["limit","rows","level","loop","contact","energy"]){let o=hn("li",`line ${r}`),a=hn("i","dot"),l=hn("span");o.append(a,l),s.append(o),e.lines[r]={line:o,text:l,dot:a}}return n.append(t,i,s),e.said=i,e}function hn(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}var Fl=n=>Math.hypot(...n);function UR(n,e,t){for(let{id:i,unit:s}of my){let r=n.tiles[i],o=uy(t[i],s),a=dy(e[i],t[i]);Rh(r.number,hy(i==="penetration"?Math.abs(e[i]):e[i],o)),Rh(r.unit,o.unit),Rh(r.limit,`of ${Number((t[i]/o.scale).toPrecision(2))}`),r.gauge.style.setProperty("--share",a.toFixed(3)),r.tile.classList.toggle("full",a>.9)}Rh(n.tiles.penetration.title,e.penetration<0?"Gap":"Depth")}function Rh(n,e){n.textContent!==e&&(n.textContent=e)}function _y(n,e,t,i,s,r=null){if(!e||!i)return;let o=e.penetration>0;UR(n,r??{force:Fl(e.force),torque:Fl(e.torque),stretch:e.stretch,penetration:e.penetration},fy(t?.limits,s,i)),n.parent.classList.toggle("pointed",!!r);let a=o||Fl(e.contactForce)>0,l={object:i.object.name,statics:i.statics.map(u=>u.name),grasped:(e.bits&1)!==0,armed:(e.bits&6)===2,contacts:e.contactsFound,clusters:e.clusters.length,touching:a},c=(e.bits&Br.constrained)!==0;n.said.textContent=c?FR(n,l,{snapshot:e,state:t,scene:i,parameters:s}):_0(l);for(let u of["limit","rows"])n.lines[u].line.hidden=!c;BR(n.lines.level,e,i),kR(n.lines.loop,e,t,i),zR(n.lines.contact,e,t),Fi(n.lines.energy,"",`The hand has put in ${Yn(e.energy,"J",1e-9)}.`)}function FR(n,e,{snapshot:t,state:i,scene:s,parameters:r}){let o=t.rows.filter(({presses:u})=>u).length,a=r.find(({name:u})=>u==="coupling_stiffness")?.value??null,l=i?.constraint??null,c={pressing:o,stiffness:a,stretch:t.stretch,force:Fl(t.force)/s.workspace.force_scale,heldBack:l?.held_back??0,squeezed:l?.squeezed??0,say:Yn};return Fi(n.lines.limit,c.heldBack>.01||c.squeezed>.1?"warn":"good",v0(c)),Fi(n.lines.rows,l?.left_out>0||l?.halvings>0?"warn":"",OR(t,l)),x0({...e,rows:l?.rows??t.rows.length,pressing:o,newtons:Yn(Fl(t.force),"N",.001),stiffness:a===null?null:Yn(a,"N/m",1)})}function OR({rows:n},e){if(!e)return"Rows: not counted yet.";let t=[`${si(e.in_model,"row")} in the contact model`];e.halvings>0&&t.push(`more were needed than fit, so its travel was halved ${e.halvings===1?"once":`${e.halvings} times`}`),e.left_out>0&&t.push(`${si(e.left_out,"contact")} had no room: nothing may move`),Number.isFinite(e.travel)&&e.travel!==null&&t.push(`free for ${Yn(e.travel,"m",1e-6)} around`);let i=y0(n);return i>0&&t.push(`${i} at the edge of ${i===1?"its cone":"their cones"}`),`${t.join("; ")}.`}function Fi(n,e,t){n.line.dataset.mood=e,n.text.textContent!==t&&(n.text.textContent=t)}function BR(n,e,t){let i=vd(e.contacts),s=t.object.levels>1?` of ${t.object.levels} levels`:"",r="Level of detail: none in use, as nothing is near.",o=i[0]?.[0]===0?", the original surface":"";i.length===1&&(r=`Level of detail at the contacts: ${i[0][0]}${s}${o}.`),i.length>1&&(r=`Levels of detail at the contacts: ${i.map(([l])=>l).join(", ")}${s}; 0 is the finest.`);let a=S0(e.contacts);Fi(n,"",a?`${r} Decided ${a}${a.includes("100 %")?"":"; there is nothing finer elsewhere"}.`:r),n.dot.style.background=i.length>0?Vr(i[0][0]):""}function kR(n,e,t,i){let s=e.hapticRate,r=i.rate;if(t?.replay)return Fi(n,"",`A recording of a loop at ${Math.round(r)} Hz.`);if(!Number.isFinite(s))return Fi(n,"","Haptic loop: not measured yet.");if(t?.run!=="running")return Fi(n,"",`Haptic loop: ${t?.run??"unknown"}.`);let o=s>=.99*r,a=t?.timing?.missed??null,l=a===null?"":`, ${si(a,"frame")} missed`;return o?Fi(n,"good",`The loop holds ${Math.round(r)} Hz${l}.`):Fi(n,"warn",`The loop runs at ${Math.round(s)} of ${Math.round(r)} Hz${l}.`)}function zR(n,e,t){if(t?.replay){let a=Number.isFinite(e.modelAge)?` The model was ${Yn(e.modelAge,"s",1e-6)} old.`:"";return Fi(n,"",`Contacts are found again where the object was.${a}`)}if(!Number.isFinite(e.contactRate))return Fi(n,"","Contacts: not measured yet.");let i=Number.isFinite(e.modelAge)?`; the model is ${Yn(e.modelAge,"s",1e-6)} old`:"",r=t?.run==="running"?e.modelWeight>.99?"good":"warn":"",o=e.contactsDropped>0?`; ${e.contactsDropped} did not fit`:"";return Fi(n,r,`Contacts found ${Ni(e.contactRate)} times a second, ${Yn(e.queryCpu,"s",1e-6)} each${i}${o}.`)}var py=[["object","the object"],["hand","where the hand holds it"],["coupling","coupling"],["near","rows near"],["press","rows that press"],["cone","friction cone"]];function xy(n,e){let t=!!e&&(e.bits&Br.constrained)!==0;if(n.hidden=!t,document.body.classList.toggle("constrained",t),!t)return;n.childElementCount===0&&n.replaceChildren(...py.map(([o,a])=>{let l=hn("span",`swatch row-key ${o}`);return l.append(hn("i"),hn("b","",a),hn("em")),l}));let i=e.rows.filter(({presses:o})=>o),s=(e.bits&1)!==0,r={object:null,hand:s?null:0,coupling:s?null:0,near:e.rows.length-i.length,press:i.length,cone:i.filter(({friction:o})=>o>0).length};py.forEach(([o],a)=>{let l=n.children[a];l.classList.toggle("active",r[o]!==0);let c=r[o]?`×${r[o]}`:"";l.lastChild.textContent!==c&&(l.lastChild.textContent=c)})}function vy(n,e,t,i=""){let s=Math.min(ks.length,Math.max(t?.object.levels??1,1));if(n.childElementCount!==s+2){let a=Array.from({length:s},(l,c)=>{let u=hn("span","swatch",""),f=c===s-1&&t?.object.levels>s?"+":"";return u.append(hn("i"),hn("b","",`${c}${f}`),hn("em")),u.firstChild.style.background=Vr(c),u});n.replaceChildren(hn("span","legend-title","Level at contacts"),...a,hn("span","legend-browsed"))}let r=new Map;for(let[a,l]of vd(e?.contacts??[])){let c=Math.min(a,ks.length-1);r.set(c,(r.get(c)??0)+l)}let o=i?`Patches of ${i}`:"";n.lastChild.textContent!==o&&(n.lastChild.textContent=o),[...n.children].slice(1,-1).forEach((a,l)=>{let c=r.get(l)??0;a.classList.toggle("active",c>0);let u=c>0?`×${c}`:"";a.lastChild.textContent!==u&&(a.lastChild.textContent=u)})}var GR=100;function yy(){return{title:"",objects:[],undone:[],done:[],chosen:0}}function VR(n){let e=(t,i)=>({source:t.source??null,name:t.name,unit:t.unit??1,position:[...i.position],quaternion:[...i.quat_xyzw],friction:t.friction??null,mass:t.mass??null,density:t.density??null,size:2*t.radius});return[e(n.object,n.start),...n.statics.map(t=>e(t,t))]}function Sy(n,e,t){Object.assign(n,{title:e.title,objects:VR(e)}),n.chosen=Math.min(n.chosen,n.objects.length-1),t||Object.assign(n,{done:[],undone:[]})}function My(n,e){n.done.push(n.objects),n.done.splice(0,n.done.length-GR),Object.assign(n,{objects:e,undone:[]})}function Ol(n){return by(n,n.done,n.undone)}function Ph(n){return by(n,n.undone,n.done)}function by(n,e,t){return e.length===0?!1:(t.push(n.objects),n.objects=e.pop(),n.chosen=Math.min(n.chosen,n.objects.length-1),!0)}function wy(n){n.done.length>0&&(n.objects=n.done.pop()),n.chosen=Math.min(n.chosen,n.objects.length-1)}var Ip=(n,e,t)=>n.map((i,s)=>s===e?{...i,...t}:i),Lp=(n,e)=>n.filter((t,i)=>i!==e),Ey=(n,e)=>[n[e],...Lp(n,e)];function Ay(n,e,t,i){let{min:s,max:r}=e.report.bounds,o=s.map((f,h)=>.5*t*(f+r[h])),a=s.map((f,h)=>t*(r[h]-f)),l=Math.max(...WR(n,i).map(({center:f,radius:h})=>f[0]+h),-1/0),c=.1*Math.max(...a),u=[(Number.isFinite(l)?l+c+.5*a[0]:0)-o[0],-o[1],-o[2]];return[...n,{source:`file:${e.number}`,name:HR(e.name),unit:t,position:u,quaternion:[0,0,0,1],friction:null,mass:null,density:null,size:Math.max(...a)}]}var HR=n=>n.replace(/\.[^.]*$/,"")||n;function WR(n,e){let t=e?[e.object,...e.statics]:[];return n.map((i,s)=>{let r=t[s];return{center:r?ml(i.quaternion,r.center).map((a,l)=>a+i.position[l]):i.position,radius:r?.radius??.5*i.size}})}function Ty({title:n,objects:e}){return{type:"compose",title:n,objects:e.map(({source:t,name:i,unit:s,position:r,quaternion:o,friction:a,mass:l,density:c},u)=>({source:t,name:i,unit:s,position:r,quat_xyzw:o,friction:a,...u===0?{mass:l,density:c}:{}}))}}function Cy([n,e,t,i]){let s=Math.max(-1,Math.min(1,2*(i*e-t*n))),r=180/Math.PI;return Math.abs(s)>1-1e-9?[0,Math.sign(s)*90,-2*Math.sign(s)*Math.atan2(n,i)*r]:[Math.atan2(2*(i*n+e*t),1-2*(n*n+e*e))*r,Math.asin(s)*r,Math.atan2(2*(i*t+n*e),1-2*(e*e+t*t))*r]}function Ry(n){let[e,t,i]=n.map((s,r)=>{let o=s*Math.PI/360,a=[0,0,0,Math.cos(o)];return a[r]=Math.sin(o),a});return Mi(i,Mi(t,e))}function oi(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}var Hs=(n,e,t="")=>{let i=Object.assign(oi("button",t,n),{type:"button"});return i.addEventListener("click",e),i},Bl=1e3;function Iy(n,{ask:e,choose:t,handles:i}){let s={parent:n,ask:e,choose:t,handles:i,composition:yy(),scene:null,mode:"translate",isOpen:!1,busy:!1,isOwn:!1,saved:"",refused:"",name:""};return addEventListener("keydown",r=>{!s.isOpen||r.target.closest?.("input, select, dialog")||!(r.ctrlKey||r.metaKey)||r.key.toLowerCase()!=="z"||(r.preventDefault(),Np(s,r.shiftKey?Ph:Ol))}),s}function Ly(n,e){n.isOpen=e,ns(n)}function Ny(n,e){n.scene=e,Sy(n.composition,e,n.isOwn),ns(n)}function Dy(n,e){let{objects:t}=n.composition;for(let{model:i,unit:s}of e)t=Ay(t,i,s,n.scene);return n.composition.chosen=t.length-1,kl(n,t)}function Uy(n,e){return kl(n,Ip(n.composition.objects,n.composition.chosen,e))}async function kl(n,e){if(n.busy)return ns(n),{ok:!1,reason:"the scene before is still being made"};My(n.composition,e);let t=await Fy(n);return t.ok||wy(n.composition),ns(n),t}async function Np(n,e){if(n.busy||!e(n.composition))return;(await Fy(n)).ok||(e===Ol?Ph:Ol)(n.composition),ns(n)}async function Fy(n){Object.assign(n,{busy:!0,isOwn:!0,saved:"",refused:""}),ns(n);let e=await n.ask(Ty(n.composition));return Object.assign(n,{busy:!1,isOwn:!1,refused:e.ok?"":e.reason??"The program refused."}),e}async function Py(n,e){let t=n.name.trim()||n.composition.title.replace(/[^A-Za-z0-9 ._-]/g,"").trim(),i=await n.ask({type:"save",name:t,value:e});i.ok||(n.refused=i.reason??"The program refused."),ns(n)}function Oy(n,{file:e}){Object.assign(n,{saved:e,refused:""}),ns(n)}function ns(n){let{composition:e,isOpen:t,mode:i,busy:s}=n,r=t&&!s&&e.objects.length>0;if(n.handles(r?e.chosen:null,i,t),!t)return;let o=document.activeElement?.dataset?.field,{objects:a,chosen:l}=e,c=oi("div","build-list");c.setAttribute("role","listbox"),c.setAttribute("aria-label","Objects of the scene"),c.append(...a.map((f,h)=>{let p=Hs("",()=>{e.chosen=h,ns(n)},"open-item");return p.setAttribute("role","option"),p.setAttribute("aria-selected",String(h===l)),p.append(oi("b","",f.name),oi("span","note",h===0?"in the hand":"stands still")),p}));let u=[XR(n),c];a[l]&&u.push(qR(n,a[l],l)),u.push(YR(n)),n.parent.replaceChildren(...u),n.parent.classList.toggle("busy",s),o&&n.parent.querySelector(`[data-field="${o}"]`)?.focus()}function XR(n){let{composition:e,mode:t,busy:i}=n,s=oi("div","build-tools"),r=(l,c)=>{let u=Hs(l,()=>{n.mode=c,ns(n)},"chip-button");return u.setAttribute("aria-pressed",String(t===c)),u},o=Hs("Undo",()=>Np(n,Ol)),a=Hs("Redo",()=>Np(n,Ph));return o.disabled=i||e.done.length===0,a.disabled=i||e.undone.length===0,s.append(r("Move","translate"),r("Turn","rotate"),o,a,Hs("Add a mesh",n.choose)),s}function qR(n,e,t){let i=oi("div","build-fields"),{objects:s}=n.composition,r=h=>kl(n,Ip(s,t,h)),o=(h,p,g,y)=>{let d=Object.assign(oi("input","value"),{type:"text",value:g,disabled:n.busy});return d.dataset.field=p,d.setAttribute("aria-label",h),d.addEventListener("change",()=>y(d.value,d)),d},a=(h,p,g,y,{open:d=!1}={})=>o(h,p,g===null?"":Ni(g),(m,v)=>{let T=m.trim()===""&&d?null:Number(m.replace(",","."));T!==null&&(m.trim()===""||!Number.isFinite(T))?(n.refused=`"${m}" is not a number.`,ns(n)):m!==v.defaultValue&&y(T)}),l=(h,p,...g)=>{let y=oi("div","build-row");y.append(oi("span","",h),...g,oi("span","unit",p)),i.append(y)};l("name","",o("name","name",e.name,h=>r({name:h}))),l("position","mm",...["x","y","z"].map((h,p)=>a(`position ${h}, mm`,`position-${h}`,Bl*e.position[p],g=>r({position:e.position.map((y,d)=>d===p?g/Bl:y)}))));let c=Cy(e.quaternion);l("turned about","°",...["x","y","z"].map((h,p)=>a(`turned about ${h}, degrees`,`turn-${h}`,c[p],g=>r({quaternion:Ry(c.map((y,d)=>d===p?g:y))})))),l("friction","",a("friction","friction",e.friction,h=>r({friction:h}),{open:!0})),t===0&&(l("mass","g",a("mass, g","mass",e.mass===null?null:Bl*e.mass,h=>r({mass:h===null?null:h/Bl,density:null}),{open:!0})),l("or density","kg/m³",a("density, kg/m³","density",e.density,h=>r({density:h,mass:null}),{open:!0}))),/^scene:/.test(e.source??"")||l("unit",`m, ${Ni(Bl*e.size)} mm long`,a("metres per unit","unit",e.unit,h=>r({unit:h,size:e.size*h/e.unit}),{}));let u=oi("div","build-tools");t>0&&u.append(Hs("Take it in the hand",()=>{n.composition.chosen=0,kl(n,Ey(s,t))}));let f=Hs("Remove",()=>kl(n,Lp(s,t)));return f.disabled=s.length<2,u.append(f),i.append(u),i}function YR(n){let e=oi("div","build-save"),t=Object.assign(oi("input","value"),{type:"text",value:n.name,placeholder:n.composition.title});t.dataset.field="save-name",t.setAttribute("aria-label","Name to save it under"),t.addEventListener("change",()=>{n.name=t.value});let i=Hs("Save",()=>Py(n,!1),"primary"),s=Hs("Save as one file",()=>Py(n,!0)),r=oi("p",n.refused?"refusal":"note",n.refused||(n.saved?`Saved: ${n.saved}`:""));r.setAttribute("role",n.refused?"alert":"status");let o=oi("div","build-tools");return o.append(t,i,s),e.append(o,r),e}var Jr=new Rr,fn=new B,vr=new B,en=new Et,By={X:new B(1,0,0),Y:new B(0,1,0),Z:new B(0,0,1)},Dp={type:"change"},ky={type:"mouseDown",mode:null},zy={type:"mouseUp",mode:null},Gy={type:"objectChange"},Uh=class extends $a{constructor(e,t=null){super(void 0,t);let i=new Fp(this);this._root=i;let s=new Op;this._gizmo=s,i.add(s);let r=new Bp;this._plane=r,i.add(r);let o=this;function a(T,S){let C=S;Object.defineProperty(o,T,{get:function(){return C!==void 0?C:S},set:function(A){C!==A&&(C=A,r[T]=A,s[T]=A,o.dispatchEvent({type:T+"-changed",value:A}),o.dispatchEvent(Dp))}}),o[T]=S,r[T]=S,s[T]=S}a("camera",e),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let l=new B,c=new B,u=new Et,f=new Et,h=new B,p=new Et,g=new B,y=new B,d=new B,m=0,v=new B;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",u),a("worldQuaternionStart",f),a("cameraPosition",h),a("cameraQuaternion",p),a("pointStart",g),a("pointEnd",y),a("rotationAxis",d),a("rotationAngle",m),a("eye",v),this._offset=new B,this._startNorm=new B,this._endNorm=new B,this._cameraScale=new B,this._parentPosition=new B,this._parentQuaternion=new Et,this._parentQuaternionInv=new Et,this._parentScale=new B,this._worldScaleStart=new B,this._worldQuaternionInv=new Et,this._worldScale=new B,this._positionStart=new B,this._quaternionStart=new Et,this._scaleStart=new B,this._getPointer=$R.bind(this),this._onPointerDown=JR.bind(this),this._onPointerHover=ZR.bind(this),this._onPointerMove=jR.bind(this),this._onPointerUp=KR.bind(this),t!==null&&this.connect(t)}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(e){if(this.object===void 0||this.dragging===!0)return;e!==null&&Jr.setFromCamera(e,this.camera);let t=Up(this._gizmo.picker[this.mode],Jr);t?this.axis=t.object.name:this.axis=null}pointerDown(e){if(!(this.object===void 0||this.dragging===!0||e!=null&&e.button!==0)&&this.axis!==null){e!==null&&Jr.setFromCamera(e,this.camera);let t=Up(this._plane,Jr,!0);t&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(t.point).sub(this.worldPositionStart)),this.dragging=!0,ky.mode=this.mode,this.dispatchEvent(ky)}}pointerMove(e){let t=this.axis,i=this.mode,s=this.object,r=this.space;if(i==="scale"?r="local":(t==="E"||t==="XYZE"||t==="XYZ")&&(r="world"),s===void 0||t===null||this.dragging===!1||e!==null&&e.button!==-1)return;e!==null&&Jr.setFromCamera(e,this.camera);let o=Up(this._plane,Jr,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&t!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),t.indexOf("X")===-1&&(this._offset.x=0),t.indexOf("Y")===-1&&(this._offset.y=0),t.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&t!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(en.copy(this._quaternionStart).invert()),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(fn),t.search("X")!==-1&&(fn.x=Math.round(fn.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(fn.y=Math.round(fn.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(fn.z=Math.round(fn.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(fn)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(t.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),vr.set(a,a,a)}else fn.copy(this.pointStart),vr.copy(this.pointEnd),fn.applyQuaternion(this._worldQuaternionInv),vr.applyQuaternion(this._worldQuaternionInv),vr.divide(fn),t.search("X")===-1&&(vr.x=1),t.search("Y")===-1&&(vr.y=1),t.search("Z")===-1&&(vr.z=1);s.scale.copy(this._scaleStart).multiply(vr),this.scaleSnap&&(t.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(fn.setFromMatrixPosition(this.camera.matrixWorld)),l=!1;t==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(fn.copy(this.rotationAxis).cross(this.eye))*a):(t==="X"||t==="Y"||t==="Z")&&(this.rotationAxis.copy(By[t]),fn.copy(By[t]),r==="local"&&fn.applyQuaternion(this.worldQuaternion),fn.cross(this.eye),fn.length()===0?l=!0:this.rotationAngle=this._offset.dot(fn.normalize())*a),(t==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&t!=="E"&&t!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(en.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(en.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(Dp),this.dispatchEvent(Gy)}}pointerUp(e){e!==null&&e.button!==0||(this.dragging&&this.axis!==null&&(zy.mode=this.mode,this.dispatchEvent(zy)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(e){return this.object=e,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(Dp),this.dispatchEvent(Gy),this.pointStart.copy(this.pointEnd))}getRaycaster(){return Jr}getMode(){return this.mode}setMode(e){this.mode=e}setTranslationSnap(e){this.translationSnap=e}setRotationSnap(e){this.rotationSnap=e}setScaleSnap(e){this.scaleSnap=e}setSize(e){this.size=e}setSpace(e){this.space=e}setColors(e,t,i,s){let r=this._gizmo.materialLib;r.xAxis.color.set(e),r.yAxis.color.set(t),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(e),r.yAxisTransparent.color.set(t),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(e),r.yAxis._color&&r.yAxis._color.set(t),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(e),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(t),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}};function $R(n){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:n.button};{let e=this.domElement.getBoundingClientRect(),t=this.viewport,i,s,r,o;return t!==null?(i=t.x,s=e.height-t.y-t.w,r=t.z,o=t.w):(i=0,s=0,r=e.width,o=e.height),{x:(n.clientX-e.left-i)/r*2-1,y:-(n.clientY-e.top-s)/o*2+1,button:n.button}}}function ZR(n){if(this.enabled)switch(n.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(n));break}}function JR(n){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(n)),this.pointerDown(this._getPointer(n)))}function jR(n){this.enabled&&this.pointerMove(this._getPointer(n))}function KR(n){this.enabled&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(n)))}function Up(n,e,t){let i=e.intersectObject(n,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||t)return i[s];return!1}var Ih=new Pi,zt=new B(0,1,0),Vy=new B(0,0,0),Hy=new xt,Lh=new Et,Dh=new Et,xs=new B,Fh=new xt,Vl=new B(1,0,0),jr=new B(0,1,0),Hl=new B(0,0,1),Nh=new B,zl=new B,Gl=new B,Fp=class extends gn{constructor(e){super(),this.isTransformControlsRoot=!0,this.controls=e,this.visible=!1}updateMatrixWorld(e){let t=this.controls;t.object!==void 0&&(t.object.updateMatrixWorld(),t.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):t.object.parent.matrixWorld.decompose(t._parentPosition,t._parentQuaternion,t._parentScale),t.object.matrixWorld.decompose(t.worldPosition,t.worldQuaternion,t._worldScale),t._parentQuaternionInv.copy(t._parentQuaternion).invert(),t._worldQuaternionInv.copy(t.worldQuaternion).invert()),t.camera.updateMatrixWorld(),t.camera.matrixWorld.decompose(t.cameraPosition,t.cameraQuaternion,t._cameraScale),t.camera.isOrthographicCamera?t.camera.getWorldDirection(t.eye).negate():t.eye.copy(t.cameraPosition).sub(t.worldPosition).normalize(),this.parent&&(Fh.copy(this.parent.matrixWorld).invert(),Fh.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(e)}dispose(){this.traverse(function(e){e.geometry&&e.geometry.dispose(),e.material&&e.material.dispose()})}},Op=class extends gn{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let e=new Yi({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),t=new rr({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=e.clone();i.opacity=.15;let s=t.clone();s.opacity=.5;let r=e.clone();r.color.setHex(16711680);let o=e.clone();o.color.setHex(65280);let a=e.clone();a.color.setHex(255);let l=e.clone();l.color.setHex(16711680),l.opacity=.5;let c=e.clone();c.color.setHex(65280),c.opacity=.5;let u=e.clone();u.color.setHex(255),u.opacity=.5;let f=e.clone();f.opacity=.25;let h=e.clone();h.color.setHex(16776960),h.opacity=.25;let p=e.clone();p.color.setHex(16776960);let g=e.clone();g.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:p,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:u,activeTransparent:h};let y=new Wt(0,.04,.1,12);y.translate(0,.05,0);let d=new un(.08,.08,.08);d.translate(0,.04,0);let m=new _n;m.setAttribute("position",new Dt([0,0,0,1,0,0],3));let v=new Wt(.0075,.0075,.5,3);v.translate(0,.25,0);function T(V,Y){let G=new $i(V,.0075,3,64,Y*Math.PI*2);return G.rotateY(Math.PI/2),G.rotateX(Math.PI/2),G}function S(){let V=new _n;return V.setAttribute("position",new Dt([0,0,0,1,1,1],3)),V}let C={X:[[new Me(y,r),[.5,0,0],[0,0,-Math.PI/2]],[new Me(y,r),[-.5,0,0],[0,0,Math.PI/2]],[new Me(v,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new Me(y,o),[0,.5,0]],[new Me(y,o),[0,-.5,0],[Math.PI,0,0]],[new Me(v,o)]],Z:[[new Me(y,a),[0,0,.5],[Math.PI/2,0,0]],[new Me(y,a),[0,0,-.5],[-Math.PI/2,0,0]],[new Me(v,a),null,[Math.PI/2,0,0]]],XYZ:[[new Me(new or(.1,0),f),[0,0,0]]],XY:[[new Me(new un(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Me(new un(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Me(new un(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},A={X:[[new Me(new Wt(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Me(new Wt(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Me(new Wt(.2,0,.6,4),i),[0,.3,0]],[new Me(new Wt(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Me(new Wt(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Me(new Wt(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new Me(new or(.2,0),i)]],XY:[[new Me(new un(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Me(new un(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Me(new un(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},_={START:[[new Me(new or(.01,2),s),null,null,null,"helper"]],END:[[new Me(new or(.01,2),s),null,null,null,"helper"]],DELTA:[[new yi(S(),s),null,null,null,"helper"]],X:[[new yi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new yi(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new yi(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},w={XYZE:[[new Me(T(.5,1),g),null,[0,Math.PI/2,0]]],X:[[new Me(T(.5,.5),r)]],Y:[[new Me(T(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new Me(T(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new Me(T(.75,1),h),null,[0,Math.PI/2,0]]]},U={AXIS:[[new yi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},L={XYZE:[[new Me(new ds(.25,10,8),i)]],X:[[new Me(new $i(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new Me(new $i(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new Me(new $i(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new Me(new $i(.75,.1,2,24),i)]]},I={X:[[new Me(d,r),[.5,0,0],[0,0,-Math.PI/2]],[new Me(v,r),[0,0,0],[0,0,-Math.PI/2]],[new Me(d,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new Me(d,o),[0,.5,0]],[new Me(v,o)],[new Me(d,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new Me(d,a),[0,0,.5],[Math.PI/2,0,0]],[new Me(v,a),[0,0,0],[Math.PI/2,0,0]],[new Me(d,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new Me(new un(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Me(new un(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Me(new un(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Me(new un(.1,.1,.1),f)]]},k={X:[[new Me(new Wt(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Me(new Wt(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Me(new Wt(.2,0,.6,4),i),[0,.3,0]],[new Me(new Wt(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Me(new Wt(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Me(new Wt(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new Me(new un(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Me(new un(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Me(new un(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Me(new un(.2,.2,.2),i),[0,0,0]]]},W={X:[[new yi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new yi(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new yi(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function N(V){let Y=new gn;for(let G in V)for(let ae=V[G].length;ae--;){let q=V[G][ae][0].clone(),K=V[G][ae][1],ne=V[G][ae][2],ue=V[G][ae][3],he=V[G][ae][4];q.name=G,q.tag=he,K&&q.position.set(K[0],K[1],K[2]),ne&&q.rotation.set(ne[0],ne[1],ne[2]),ue&&q.scale.set(ue[0],ue[1],ue[2]),q.updateMatrix();let Q=q.geometry.clone();Q.applyMatrix4(q.matrix),q.geometry=Q,q.renderOrder=1/0,q.position.set(0,0,0),q.rotation.set(0,0,0),q.scale.set(1,1,1),Y.add(q)}return Y}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=N(C)),this.add(this.gizmo.rotate=N(w)),this.add(this.gizmo.scale=N(I)),this.add(this.picker.translate=N(A)),this.add(this.picker.rotate=N(L)),this.add(this.picker.scale=N(k)),this.add(this.helper.translate=N(_)),this.add(this.helper.rotate=N(U)),this.add(this.helper.scale=N(W)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(e){let i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:Dh;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){let o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(en.setFromEuler(Ih.set(0,0,0)),o.quaternion.copy(i).multiply(en),Math.abs(zt.copy(Vl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(en.setFromEuler(Ih.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(en),Math.abs(zt.copy(jr).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(en.setFromEuler(Ih.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(en),Math.abs(zt.copy(Hl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(en.setFromEuler(Ih.set(0,Math.PI/2,0)),zt.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(Hy.lookAt(Vy,zt,jr)),o.quaternion.multiply(en),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),fn.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),fn.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(fn),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(zt.copy(Vl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(zt.copy(jr).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(zt.copy(Hl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(zt.copy(Hl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(zt.copy(Vl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(zt.copy(jr).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(Lh.copy(i),zt.copy(this.eye).applyQuaternion(en.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(Hy.lookAt(this.eye,Vy,jr)),o.name==="X"&&(en.setFromAxisAngle(Vl,Math.atan2(-zt.y,zt.z)),en.multiplyQuaternions(Lh,en),o.quaternion.copy(en)),o.name==="Y"&&(en.setFromAxisAngle(jr,Math.atan2(zt.x,zt.z)),en.multiplyQuaternions(Lh,en),o.quaternion.copy(en)),o.name==="Z"&&(en.setFromAxisAngle(Hl,Math.atan2(zt.y,zt.x)),en.multiplyQuaternions(Lh,en),o.quaternion.copy(en))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(e)}},Bp=class extends Me{constructor(){super(new Us(1e5,1e5,2,2),new Yi({visible:!1,wireframe:!0,side:Ii,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(e){let t=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(t="local"),Nh.copy(Vl).applyQuaternion(t==="local"?this.worldQuaternion:Dh),zl.copy(jr).applyQuaternion(t==="local"?this.worldQuaternion:Dh),Gl.copy(Hl).applyQuaternion(t==="local"?this.worldQuaternion:Dh),zt.copy(zl),this.mode){case"translate":case"scale":switch(this.axis){case"X":zt.copy(this.eye).cross(Nh),xs.copy(Nh).cross(zt);break;case"Y":zt.copy(this.eye).cross(zl),xs.copy(zl).cross(zt);break;case"Z":zt.copy(this.eye).cross(Gl),xs.copy(Gl).cross(zt);break;case"XY":xs.copy(Gl);break;case"YZ":xs.copy(Nh);break;case"XZ":zt.copy(Gl),xs.copy(zl);break;case"XYZ":case"E":xs.set(0,0,0);break}break;default:xs.set(0,0,0)}xs.length()===0?this.quaternion.copy(this.cameraQuaternion):(Fh.lookAt(fn.set(0,0,0),xs,zt),this.quaternion.setFromRotationMatrix(Fh)),super.updateMatrixWorld(e)}};function Wy(n,e){let t=new Uh(n.view.camera,n.canvas),i={stage:n,controls:t,index:null,isDragging:!1};return t.setSize(.9),t.addEventListener("change",()=>{n.dirty=!0}),t.addEventListener("dragging-changed",({value:s})=>{i.isDragging=s;let r=$n(n)[i.index];!s&&r&&e({position:r.group.position.toArray(),quaternion:r.group.quaternion.toArray()})}),i}function kp(n,e,t){let{stage:i,controls:s}=n,r=e===null?null:$n(i)[e];n.index=r?e:null;let o=s.getHelper();r?(s.setMode(t),s.attach(r.group),i.scene.add(o)):(s.detach(),i.scene.remove(o)),i.dirty=!0}function Xy(n,e){if(n.index===null||e.button!==0)return!1;let t=n.stage.canvas.getBoundingClientRect();return n.controls.pointerHover({x:(e.clientX-t.left)/t.width*2-1,y:1-(e.clientY-t.top)/t.height*2,button:e.button}),n.controls.axis!==null}function vs(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}function Yy(n,e){let t=vs("p","note","Choose a level to see its convex patches, each in a colour of its own. What contacts use at this moment stands in the colours of the legend."),i=vs("div");return n.append(t,i),{list:i,browse:e,rows:[],scene:null}}function $y(n,e){n.scene=e;let t=[e.object,...e.statics];n.rows=t.map((i,s)=>QR(n,i,s)),n.list.replaceChildren(...n.rows.map(i=>i.box))}function QR(n,e,t){let i=vs("section","level-row"),s=vs("div","level-head"),r=vs("i",t===0?"held":"fixed");s.append(r,vs("h2","",e.name),vs("span","note",si(e.levels,"level")));let o=vs("div","chips");o.setAttribute("role","radiogroup"),o.setAttribute("aria-label",`Level of the ${e.name}`);let a=vs("p","note"),l={box:i,about:e,body:t,caption:a,chips:[],level:null},c=[null,...(e.level_list??[]).keys()];for(let u of c){let f=Object.assign(vs("button","chip-button",u===null?"as it is":String(u)),{type:"button"});f.setAttribute("role","radio"),f.setAttribute("aria-label",u===null?`${e.name} as it is`:`${e.name}, level ${u}`),u!==null&&u>0&&e.level_list[u].free&&f.classList.add("free"),f.addEventListener("click",()=>qy(n,l,u)),l.chips.push({chip:f,level:u}),o.append(f)}return i.append(s,o,a),qy(n,l,null),l}function qy(n,e,t){let i=e.level!==t;e.level=t;for(let{chip:s,level:r}of e.chips)s.setAttribute("aria-checked",String(r===t));e.caption.textContent=eP(e.about,t),i&&n.browse(e.body,t)}function eP(n,e){if(e===null)return"";let t=n.level_list[e];return e===0?`The original surface: ${si(t.triangles,"triangle")} in ${si(t.patches,"convex patch","convex patches")}.`:oh({about:n},e)?`${si(t.triangles,"triangle")} in ${si(t.patches,"convex patch","convex patches")}; nowhere more than ${Yn(t.deviation,"m",1e-9)} off the original.`:`${si(t.patches,"group")} of patches below, merged pairwise. No surface of its own: contacts here are with convex hulls.`}function Zy(n){return n.rows.filter(e=>e.level!==null).map(e=>`${e.about.name} ${e.level}`).join(", ")}var zp={ball_joint:{size:.076,triangles:274120},block_on_gear:{size:.1,triangles:1616},blocks:{size:.1,triangles:32},conforming:{size:.2,triangles:2e5},cup_spoon:{size:.2,triangles:149988},ellipsoid:{size:.02,triangles:22002},file_on_cad:{size:.2,triangles:1344},golf:{size:.12,triangles:282764},hammer_on_torus:{size:.24,triangles:1036},jaws:{size:.074,triangles:87514},plate:{size:.1,triangles:2016},simple_cup_spoon:{size:.2,triangles:5340},spoon_in_cup:{size:.2,triangles:149988}};var Jy={ball_joint:"Turn the ball in its socket: it has half a millimetre of play.",block_on_gear:"Drag the block over the gear: ridges catch ridges.",blocks:"Turn the upper block about the vertical: its stripes climb out of the others.",conforming:"Press the waves together and turn: everything touches at once.",cup_spoon:"Lead the spoon through the handle of the cup.",ellipsoid:"Roll the ellipsoid over the ball; its tip and its flank feel different.",file_on_cad:"Scrape the file over the flange: rough on rough.",golf:"Tap the ball, then slide the club over its dimples.",hammer_on_torus:"Stroke the ring with the hammer, along and across its ridges.",jaws:"Close the bite, then slide the cusps over each other.",plate:"Draw the probe across the ridges, slowly and fast.",simple_cup_spoon:"Lead the spoon through the handle: few triangles, the same way.",spoon_in_cup:"Nobody holds it: watch the spoon fall into the cup."},jy=n=>Jy[n]??"",jN=Object.keys(Jy);function Xt(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}var Kr=(n,e,t="")=>{let i=Object.assign(Xt("button",t,n),{type:"button"});return i.addEventListener("click",e),i},tP=96,nP=[["millimetres",.001],["centimetres",.01],["inches",.0254],["metres",1]];function eS(n,{ask:e,send:t,room:i,limit:s,add:r}){let o={dialog:n,ask:e,send:t,room:i,limit:s,add:r,menu:{scenes:[],recordings:[],meshes:[]},name:"",model:null,busy:null};n.addEventListener("click",a=>{a.target===n&&n.close()});for(let a of["dragenter","dragover"])addEventListener(a,l=>{[...l.dataTransfer?.types??[]].includes("Files")&&(l.preventDefault(),document.body.classList.add("dropping"))});return addEventListener("dragleave",a=>{a.relatedTarget||document.body.classList.remove("dropping")}),addEventListener("drop",a=>{a.preventDefault(),document.body.classList.remove("dropping"),sS(o,[...a.dataTransfer?.files??[]])}),o}function tS(n,e){n.menu=e,n.dialog.open&&!n.model&&iS(n)}function nS(n,e){n.name=e,n.model=null,iS(n),n.dialog.open||n.dialog.showModal()}function iS(n){let{scenes:e,recordings:t,meshes:i=[]}=n.menu,s=l=>{let c=Xt("div","open-list");return c.append(...l.map(({name:u,title:f})=>{let h=Kr("",()=>sP(n,u),"open-item");h.append(Xt("b","",f||u));let p=jy(u)||(f&&f!==u?u:"");return p&&h.append(Xt("span","note",p)),iP(h,u),h.setAttribute("aria-current",String(u===n.name)),h})),c},r=Object.assign(Xt("input"),{type:"file",accept:M0(i),id:"mesh-file",multiple:!0});r.addEventListener("change",()=>sS(n,[...r.files]));let o=Xt("label","drop-zone");o.htmlFor=r.id,o.append(Xt("b","","Files of your own"),Xt("span","note",b0(i)),r);let a=[Xt("h2","","Open"),o,Xt("h3","","Scenes"),s(e)];t.length>0&&a.push(Xt("h3","","Recordings"),s(t)),n.dialog.replaceChildren(...a,Gp(n,[Kr("Cancel",()=>n.dialog.close())]))}function iP(n,e){let t=zp[e];if(!t)return;let i=Xt("i","open-picture");i.style.backgroundPositionY=`${(-tP*Object.keys(zp).indexOf(e)).toFixed(0)}px`,i.setAttribute("aria-hidden","true"),n.classList.add("pictured"),n.append(Xt("span","note",`${Ni(1e3*t.size)} mm, ${si(t.triangles,"triangle")}`),i)}function Gp(n,e,t=""){let i=Xt("div","dialog-foot"),s=Xt("p","refusal",t);return s.setAttribute("role","alert"),i.append(s,...e),n.said=s,i}async function sP(n,e){(await Vp(n,{type:"open",value:e})).ok&&n.dialog.close()}async function Vp(n,e){if(n.busy)return{ok:!1};n.dialog.classList.add("busy"),n.busy=n.ask(e);let t=await n.busy;return n.busy=null,n.dialog.classList.remove("busy"),!t.ok&&n.said&&(n.said.textContent=t.reason??"The program refused."),t}async function sS(n,e){if(e.length<=1){e[0]&&await Ky(n,e[0]);return}let t=[];for(let i of e){if(!(await Ky(n,i)).ok||n.model?.report===void 0||n.model.report.verdict==="rejected")return;t.push({model:n.model,unit:n.model.unit})}n.dialog.close(),n.add(t)}async function Ky(n,e){for(;n.busy;)await n.busy;n.model={name:e.name};let t=Object.assign(Xt("progress"),{max:1,value:0});n.dialog.replaceChildren(Xt("h2","",e.name),Xt("p","note","Sending and looking at it …"),t,Gp(n,[Kr("Cancel",()=>n.dialog.close())])),n.dialog.open||n.dialog.showModal();let i=new Uint8Array(await e.arrayBuffer()),s=Vp(n,{type:"upload",name:e.name.slice(-120),value:i.length});await rP(n,i,t);let r=await s;return r.ok&&e.name.endsWith(".mcap")&&n.dialog.close(),r}async function rP(n,e,t){let i=Math.max(1024,Math.min(n.limit(),65536)-64);for(let s=0;s<e.length&&n.busy;){for(let r=0;r<8&&s<e.length&&n.room()<4*i;r++){if(!n.send(L0(e.subarray(s,s+i))))return;s+=i}t.value=Math.min(1,s/e.length),await new Promise(r=>setTimeout(r,10))}}function rS(n,e){n.model=e;let{report:t}=e,i=t.verdict==="usable",s=t.verdict==="repairable",r=Xt("p",`verdict ${t.verdict}`,{usable:"Ready to use",repairable:"Needs repair first",rejected:"Cannot be used"}[t.verdict]??t.verdict),o=Xt("p","",`${si(t.triangles,"triangle")}, ${t.closed?"closed":"open"}, ${si(t.components,"part")}.`),a=Xt("ul","reasons");for(let y of[...t.reasons,...t.warnings])a.append(Xt("li","",y));let l=Object.assign(Xt("select"),{id:"mesh-unit"}),c=[...nP.map(([y,d])=>[`${y} (${Qy(t,d)})`,d]),[`whatever makes it as large as the object (${Qy(t,e.object_radius/t.radius)})`,e.object_radius/t.radius]];l.append(...c.map(([y,d])=>new Option(y,String(d)))),l.value=String(e.unit);let u=Object.assign(Xt("label","","Its unit is "),{htmlFor:l.id}),f=Xt("p","unit-choice");f.append(u,l);let h=y=>async()=>{(await Vp(n,{type:"place",name:y,value:Number(l.value),repair:s})).ok&&n.dialog.close()},p=s?"Repair and ":"",g=[Kr("Cancel",()=>n.dialog.close())];(i||s)&&(g.push(Kr("Add it to the scene",async()=>{n.dialog.close(),n.add([{model:e,unit:Number(l.value)}])})),g.push(Kr(p?"Repair and touch it":"Touch it",h("touch")),Kr(p?"Repair and hold it":"Hold it",h("hold"),"primary"))),n.dialog.replaceChildren(Xt("h2","",e.name),r,o,a,...i||s?[f]:[],Gp(n,g)),n.dialog.open||n.dialog.showModal()}function Qy(n,e){let t=e*Math.max(...n.bounds.max.map((i,s)=>i-n.bounds.min[s]));return Number.isFinite(t)?t<.9995?`${Ni(1e3*t)} mm`:`${Ni(t)} m`:"–"}var oP=[.05,.1,.25,.5,1,2,4];function oS(n,e){let t={parent:n,act:e,held:!1,waiting:!1,next:null};t.play=hi("pause","Pause","P",e.pause),t.slider=Object.assign(document.createElement("input"),{type:"range",min:0,max:1,step:"any"}),t.slider.setAttribute("aria-label","Time in the recording"),t.text=document.createElement("output"),t.slider.addEventListener("input",()=>{t.held=!0,aS(t,Number(t.slider.value))});for(let s of["change","blur"])t.slider.addEventListener(s,()=>{t.held=!1});t.speed=Object.assign(document.createElement("select"),{title:"How fast it is shown"}),t.speed.setAttribute("aria-label",t.speed.title),t.speed.append(...oP.map(s=>new Option(`${s} ×`,String(s)))),t.speed.value="1",t.speed.addEventListener("change",()=>e.speed(Number(t.speed.value))),t.strip=document.createElement("canvas"),t.strip.setAttribute("aria-hidden","true"),t.force=[];let i=Object.assign(document.createElement("div"),{className:"track"});return i.append(t.strip,t.slider),n.append(t.play,i,t.speed,t.text),t}async function aS(n,e){if(n.waiting){n.next=e;return}n.waiting=!0,await n.act.seek(e),n.waiting=!1;let t=n.next;n.next=null,t!==null&&aS(n,t)}function lS(n,{force:e}){n.force=e,n.drawnAt=null}function aP(n){let{clientWidth:e,clientHeight:t}=n.strip,i=Ct("force"),s=`${e} ${t} ${i}`;if(n.drawnAt===s||e===0)return;n.drawnAt=s,Object.assign(n.strip,{width:e,height:t});let r=n.strip.getContext("2d"),o=n.force.reduce((a,l)=>Math.max(a,l??0),0);r.clearRect(0,0,e,t),r.fillStyle=i,n.force.forEach((a,l)=>{let c=o>0?t*(a??0)/o:0;r.fillRect(l*e/n.force.length,t-c,e/n.force.length+.5,c)})}function cS(n,e,t){let i=e?.replay??null;if(n.parent.hidden=!i,!i)return;let s=n.held||n.waiting?Number(n.slider.value):t?.time??0;n.slider.max=i.seconds,!n.held&&!n.waiting&&(n.slider.value=s),n.slider.setAttribute("aria-valuetext",`${Fr(s)} of ${Fr(i.seconds)}`),n.text.textContent=`${Fr(s)} / ${Fr(i.seconds)}`,document.activeElement!==n.speed&&(n.speed.value=String(i.speed??1)),aP(n);let r=e.run==="paused";hl(n.play,r?"play":"pause"),Xo(n.play,r?"Play":"Hold","P")}var uS=26,lP=110,Hp=[["1","+x",[1,0,0]],["2","-x",[-1,0,0]],["3","+y",[0,1,0]],["4","-y",[0,-1,0]],["5","+z",[0,0,1]],["6","-z",[0,0,-1]]];function oa(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}function fS(n,e,t){let i=oa("div","compass"),s=document.createElementNS("http://www.w3.org/2000/svg","svg");i.setAttribute("role","group"),i.setAttribute("aria-label","Views along the axes"),s.setAttribute("viewBox","-36 -36 72 72"),s.setAttribute("aria-hidden","true"),i.append(s);let r=Hp.map(([l,c,u])=>{let f=document.createElementNS("http://www.w3.org/2000/svg","line"),h=Object.assign(oa("button",`axis axis-${c[1]} ${c[0]==="+"?"plus":"minus"}`,c[0]==="+"?c[1]:""),{type:"button",title:`View from ${c} (${l})`});return h.setAttribute("aria-label",`View from ${c}`),h.addEventListener("click",()=>t(u)),f.classList.add(`axis-${c[1]}`),c[0]==="+"&&s.append(f),i.append(h),{way:new B(...u),line:f,button:h}}),o=l=>{let c=oa("div",`ruler ${l}`),u=oa("span"),f=oa("i");return c.append(u,f),{box:c,text:u,length:f}},a={parent:n,names:e,ends:r,scale:o("ruler-scale"),force:o("ruler-force"),tags:[]};return n.replaceChildren(a.force.box,a.scale.box,i),a}function dS(n,e,t){let{view:i,options:s,canvas:r}=e;if(!e.object||r.clientHeight===0)return;let{right:o,up:a,forward:l}=hr(i);for(let{way:h,line:p,button:g}of n.ends){let y=uS*h.dot(o),d=-uS*h.dot(a);p.setAttribute("x2",y.toFixed(1)),p.setAttribute("y2",d.toFixed(1)),g.style.transform=`translate(${y.toFixed(1)}px, ${d.toFixed(1)}px)`,g.style.zIndex=h.dot(l)<0?2:1}let c=e.root.localToWorld(e.object.group.position.clone()),u=cl(i,ul(i,c),r.clientHeight)*e.radius;hS(n.scale,u,"m",1e-9);let f=t?.metresPerNewton;n.force.box.hidden=!(f>0)||!s.forces,f>0&&hS(n.force,u/(Yd*f),"N",1e-6),cP(n,e,a)}function hS({text:n,length:e},t,i,s){let r=O0(lP*t),o=Yn(r,i,s).replace(/\.0+(?= )/,"");n.textContent!==o&&(n.textContent=o),e.style.width=`${(r/t).toFixed(1)}px`}function cP(n,e,t){let{options:i,view:s,canvas:r}=e,o=$n(e);if(n.names.hidden=!i.names,!i.names)return;(n.tags.length!==o.length||n.tags.some(({textContent:l},c)=>l!==o[c].about.name))&&(n.tags=o.map(({about:l},c)=>oa("span",`name-tag ${c===0?"held":"fixed"}`,l.name)),n.names.replaceChildren(...n.tags));let a=new B;o.forEach(({about:l,group:c},u)=>{e.root.localToWorld(a.set(...l.center).applyQuaternion(c.quaternion).add(c.position)),a.addScaledVector(t,(u===0?.8:-.8)*l.radius/e.radius).project(s.camera);let f=(a.x+1)/2*r.clientWidth,h=(1-a.y)/2*r.clientHeight,p=a.z<1&&f>0&&f<r.clientWidth&&h>0&&h<r.clientHeight;n.tags[u].style.visibility=p?"":"hidden",n.tags[u].style.transform=`translate(${f.toFixed(0)}px, ${h.toFixed(0)}px) translate(-50%, -50%)`})}function uP(n,e,t){let i=e?[e,...n]:n,s=i[0]?.time??0,r=(i.at(-1)?.time??0)-s;if(!(r>0)||r>1||!(t>0))return{samples:new Float32Array(0),last:i.at(-1)??null};let o=new Float32Array(Math.floor(r*8e3)),a=1;for(let l=0;l<o.length;l++){let c=s+l/8e3;for(;a<i.length-1&&i[a].time<c;)a+=1;let u=(i[a].force-i[a-1].force)/t;o[l]=Number.isFinite(u)?Math.tanh(12*u):0}return{samples:o,last:i.at(-1)}}var pS=()=>({context:null,on:!1,last:null,until:0,played:0});function mS(n){return n.on=!n.on,n.last=null,n.on?(n.context??=new AudioContext,n.context.resume()):n.context?.suspend(),n.on}function gS(n,e,t,i){if(!n.on||!n.context)return;let s=Array.from({length:e.rows},(f,h)=>{let p=g=>e.values[h*e.columns+t[g]];return{time:e.time+p("t"),force:Math.hypot(p("force_x"),p("force_y"),p("force_z"))}}),{samples:r,last:o}=uP(s,n.last,i);if(n.last=o,r.length===0)return;let{context:a}=n,l=a.createBuffer(1,r.length,8e3);l.copyToChannel(r,0);let c=new AudioBufferSourceNode(a,{buffer:l});c.connect(a.destination);let u=a.currentTime;(n.until<u||n.until>u+3*.08)&&(n.until=u+.08),c.start(n.until),n.until+=r.length/8e3,n.played+=1}function _S(n,e,t=()=>{}){let i=e.map(([r,o])=>{let a=Object.assign(document.createElement("button"),{type:"button",textContent:o});return a.setAttribute("role","tab"),a.setAttribute("aria-controls",r),a.addEventListener("click",()=>s(r)),{id:r,tab:a}});function s(r){for(let{id:o,tab:a}of i)a.setAttribute("aria-selected",String(o===r)),a.tabIndex=o===r?0:-1,document.getElementById(o).hidden=o!==r;t(r)}return n.addEventListener("keydown",({key:r})=>{let o={ArrowRight:1,ArrowLeft:-1}[r],a=i.findIndex(({tab:c})=>c===document.activeElement);if(!o||a<0)return;let l=i[(a+o+i.length)%i.length];s(l.id),l.tab.focus()}),n.append(...i.map(({tab:r})=>r)),s(e[0][0]),s}var hP=.06,fP=1.5;function Oh(n,e,t){let i=Math.max(hP,Math.min(fP,e)),s=Mi(ju([0,0,1],n+Math.PI/2),ju([1,0,0],Math.PI/2));return{azimuth:n,radius:t,shown:i,turn:s,metres:t/i}}function xS(){return{source:null,last:null,isHeld:!1,down:new Set}}function vS(n,e,t,i,s){let r=new Set(n.down);for(let{source:a,grabs:l}of e)l?n.down.add(a):n.down.delete(a);if(n.source===null){let a=e.find(({source:l,grabs:c,pose:u})=>c&&u&&!r.has(l));return a?(Object.assign(n,{source:a.source,last:a.pose,isHeld:!1}),"press"):null}let o=e.find(({source:a})=>a===n.source);return!o?.grabs||!o.pose||n.isHeld&&!i.clutch?(Bh(n),"letGo"):(n.isHeld||=i.clutch,o.free||dP(n.last,o.pose,t,i,s),n.last=o.pose,null)}function Bh(n){Object.assign(n,{source:null,last:null,isHeld:!1})}function dP(n,e,t,i,s){let r=ml(t.turn,e.position.map((a,l)=>a-n.position[l]));Ku(i,r.map(a=>a*t.metres),s);let o=Mi(e.quaternion,kr(n.quaternion));Ad(i,Mi(Mi(t.turn,o),kr(t.turn)),s)}var yS=[["immersive-vr","Enter VR"],["immersive-ar","Enter AR"]],pP=[0,-.3,-.55],mP=.22,gP=.2,Wp=60;async function MS(n=navigator.xr){if(!n)return[];let e=await Promise.all(yS.map(([t])=>n.isSessionSupported(t).catch(()=>!1)));return yS.filter((t,i)=>e[i])}function bS(n){return{world:n,session:null,mode:null,busy:!1,rig:new cn,room:null,hand:xS(),grabbing:new Set,freeing:new Set,last:0,pulsed:0,frames:0}}var wS=n=>!!n?.session&&n.hand.source!==null;async function ES(n,e){if(!n.busy){if(n.session){await n.session.end();return}n.busy=!0;try{await _P(n,e)}finally{n.busy=!1}n.world.changed()}}async function _P(n,e){let{stage:t}=n.world,{renderer:i}=t,s=await navigator.xr.requestSession(e,{optionalFeatures:["hand-tracking"]});s.addEventListener("visibilitychange",()=>{s.visibilityState!=="visible"&&AS(n)});for(let[o,a]of[["select",n.grabbing],["squeeze",n.freeing]])s.addEventListener(`${o}start`,({inputSource:l})=>a.add(l)),s.addEventListener(`${o}end`,({inputSource:l})=>a.delete(l));Object.assign(n,{session:s,mode:e,last:0,frames:0}),Xp(n,Oh(t.view.azimuth,mP,t.radius)),t.scene.add(n.rig),n.rig.add(t.view.camera),i.xr.enabled=!0,i.xr.setReferenceSpaceType("local"),e==="immersive-vr"&&i.setClearColor(Ct("stage"),1);let r=i.xr.setSession(s);s.addEventListener("end",()=>SS(n,s));try{await r}catch(o){throw await s.end().catch(()=>{}),SS(n,s),o}n.session===s&&i.xr.setAnimationLoop((o,a)=>vP(n,o,a))}function Xp(n,e){let{rig:t,world:{stage:i}}=n;n.room=e,t.quaternion.fromArray(e.turn),t.scale.setScalar(1/e.shown),t.position.fromArray(pP).applyQuaternion(t.quaternion).multiplyScalar(-1/e.shown).add(i.view.target),t.updateMatrixWorld()}function SS(n,e){if(n.session!==e)return;let{stage:t,leave:i,changed:s}=n.world,{renderer:r}=t;n.session=n.mode=null,AS(n),i();for(let o of[n.grabbing,n.freeing,n.hand.down])o.clear();r.xr.setAnimationLoop(null),r.setAnimationLoop(null),r.xr.enabled=!1,r.setClearColor(0,0),n.rig.remove(t.view.camera),t.scene.remove(n.rig),t.view.camera.scale.setScalar(1),Al(t),Ki(t.view),s()}function AS(n){n.hand.source!==null&&(Bh(n.hand),n.world.player.letGo())}function xP(n,e,t){let i=n.getPose(e.gripSpace,t);if(!i||i.emulatedPosition)return null;let{position:s,orientation:r}=i.transform;return{position:[s.x,s.y,s.z],quaternion:[r.x,r.y,r.z,r.w]}}function vP(n,e,t){let{world:i,session:s}=n;if(!s)return;n.room.radius!==i.stage.radius&&Xp(n,Oh(n.room.azimuth,n.room.shown,i.stage.radius));let r=Math.min(.1,(e-n.last)/1e3);n.last=e,n.frames+=1;let o=i.stage.renderer.xr.getReferenceSpace(),a=[...s.inputSources].filter(({gripSpace:c})=>c).map(c=>({source:c,grabs:n.grabbing.has(c),free:n.freeing.has(c),pose:xP(t,c,o)}));if(yP(n,a),n.hand.source===null)for(let{source:c}of a)SP(n,c,r);else MP(n,e);i.moment();let{stage:l}=i;l.renderer.shadowMap.needsUpdate=l.moved,l.moved=l.dirty=!1,l.renderer.render(l.scene,l.view.camera)}function yP(n,e){let{player:t,take:i}=n.world,s=vS(n.hand,e,n.room,t.hand,t.workspace());s==="letGo"?t.letGo():s==="press"&&!t.mayMove()?(Bh(n.hand),i()):s==="press"&&t.press(),n.hand.source!==null&&(dr(t.hand,performance.now()/1e3),t.moved(!0),t.give())}function SP(n,{gamepad:e},t){let[,,i=0,s=0]=e?.axes??[];if(Math.hypot(i,s)<gP)return;let{azimuth:r,shown:o}=n.room;Xp(n,Oh(r+1.5*t*i,o*Math.exp(-1.2*t*s),n.world.stage.radius))}function MP(n,e){let{gamepad:t}=n.hand.source,i=n.world.strength();if(!t||i<.02||e-n.pulsed<Wp)return;n.pulsed=e;let[s]=t.hapticActuators??[];s?.pulse?s.pulse(i,Wp+20)?.catch?.(()=>{}):t.vibrationActuator?.playEffect?.("dual-rumble",{duration:Wp+20,strongMagnitude:i,weakMagnitude:.5*i}).catch(()=>{})}var Gt=n=>document.getElementById(n),bP=50,fe={connected:!1,hello:null,scene:null,meshes:new Map,state:null,parameters:[],snapshot:null,shown:null,refusal:null,counts:{snapshot:0,channels:0,mesh:0,event:0},holding:!1,turned:!1,trouble:null,progress:null,fresh:!1,asking:!1,sent:0,faultName:()=>fe.hello?.faults?.[fe.snapshot?.fault??0]??"fault"},ai=D0(),wP=C0(),nt=null,fi=null,aa=null,Xs=null,Oi=ey(Gt("plots"),[["PNG","Save the plots as a picture",()=>ly(Oi,FP()).toBlob(n=>TS(CS("png"),n))],["CSV","Save the plots as a table",()=>TS(CS("csv"),new Blob([cy(Oi)],{type:"text/csv"}))]],n=>fe.state?.replay&&tn.seek(n)),EP=gy(Gt("readouts")),$p=pS(),LS=Yy(Gt("levels"),(n,e)=>nt&&$n(nt)[n]&&nx(nt,$n(nt)[n],e)),Yp=eS(Gt("opener"),{ask:n=>gr(fi,n),send:n=>mx(fi,n),room:()=>gx(fi),limit:()=>fe.hello?.max_message??4096,add:n=>{OP("build"),Dy(la,n)}}),la=Iy(Gt("build"),{ask:n=>gr(fi,n),choose:()=>{tn.open(),Gt("mesh-file").click()},handles:(n,e,t)=>{nt&&(Q_(nt,t),t&&!Xs&&(Xs=Wy(nt,i=>Uy(la,i))),Xs&&kp(Xs,n,e))}}),AP=yx(Gt("parameters"),(n,e)=>gr(fi,{type:"set",name:n,value:e}));async function Ws(n){let e=await gr(fi,n);return e.ok||(fe.refusal={text:e.reason??"The program refused.",until:performance.now()/1e3+6}),e}var tn={open:()=>Gt("opener").open?Gt("opener").close():nS(Yp,fe.scene?.name??""),seek:n=>Ws({type:"seek",value:n}),pause:()=>Ws({type:"pause",value:fe.state?.run!=="paused"}),step:()=>Ws({type:"step",value:1}),reset:()=>Ws({type:"reset"}),record:()=>Ws({type:"record",value:!fe.state?.recording}),device:n=>Ws({type:"use_device",value:n}).then(e=>Xl(e.ok&&n.startsWith("web:"))),help:()=>Gt("help").open?Gt("help").close():TP(),theme:()=>RP(),view:n=>{nt&&(ix(nt,{[n]:!nt.options[n]}),Md(ca,nt.options))},fit:()=>nt&&qu(nt.view),speed:n=>Ws({type:"speed",value:n}),sound:()=>Sd(ca,mS($p)),look:n=>nt&&p0(nt.view,n),zoom:n=>nt&&Wo(nt.view,n)};function TP(){Gt("help").showModal(),Gt("help").scrollTop=0}var ca=w0(tn),CP=fS(Gt("rulers"),Gt("names"),tn.look),NS=oS(Gt("replay"),tn),RP=X0(()=>{nt&&uh(nt),Ch(Oi)}),PP={hello:n=>{fe.hello=n},scene:n=>{let e=n.refined&&fe.snapshot!==null;fe.scene=n,fe.meshes.clear(),$y(LS,n),!e&&(fe.scene.refined=!1,fe.snapshot=fe.shown=null,fe.fresh=!1,yr("Loading the objects …"))},mesh:n=>{if(fe.counts.mesh+=1,fe.meshes.set(n.number,n),![fe.scene.object,...fe.scene.statics].map(i=>i.mesh).every(i=>fe.meshes.has(i)))return;let t=fe.scene.refined;Xs&&!t&&kp(Xs,null),nt&&j_(nt,fe.scene,fe.meshes,t),Ny(la,fe.scene),t||yr(fe.trouble)},level:n=>{nt&&ex(nt,n)},relief:n=>{nt&&tx(nt,n)},strip:n=>lS(NS,n),menu:n=>tS(Yp,n),model:n=>rS(Yp,n),saved:n=>Oy(la,n),progress:({what:n,share:e})=>{fe.progress=n,n?(Gt("opener").close(),yr(`${n[0].toUpperCase()}${n.slice(1)} …`,e,()=>Ws({type:"cancel"}))):yr(fe.trouble)},parameters:n=>{fe.parameters=n.list,Sx(AP,n.list)},state:n=>{fe.state&&fe.state.session!==n.session&&IP(),fe.state=n,Xl(n.holder==="you")},event:n=>{fe.counts.event+=1,bx(Gt("events"),n),ny(Oi,n.time,n.kind),["recording_ended","held_back","squeezed"].includes(n.kind)&&(fe.refusal={text:`${Zu(n)}.`,until:performance.now()/1e3+10})},camera:n=>{nt&&md(nt.view,n)},channels:n=>{fe.counts.channels+=1;let e=["t",...fe.hello.channels.map(t=>t.name).filter(t=>t!=="t")];sy(Oi,n,e),gS($p,n,Object.fromEntries(e.map((t,i)=>[t,i])),fe.state?.limits?.force??Jp())},snapshot:n=>{fe.counts.snapshot+=1;let e=n.bits&~(fe.snapshot?.bits??0);fe.snapshot=n,e&Br.fault&&(ai.clutch=!1),fe.fresh=!0,n.metresPerNewton>0&&iy(Oi,fe.scene.object.radius,fe.scene.tolerance,n.metresPerNewton),ry(Oi,n.time,n.hapticRate,n.contactRate)}};function IP(){ai.clutch=!1,nt&&md(nt.view,null),oy(Oi),Gt("events").replaceChildren()}function yr(n,e=null,t=null){let i=Gt("veil");if(i.hidden=!n,i.classList.toggle("working",e!==null),!n){i.replaceChildren();return}if(e!==null&&i.querySelector("progress")){i.querySelector("p").textContent=n,i.querySelector("progress").value=e;return}let s=Object.assign(document.createElement("p"),{textContent:n}),r=Object.assign(document.createElement("progress"),{max:1,value:e??0});r.setAttribute("aria-label","How far it is");let o=Object.assign(document.createElement("button"),{type:"button",className:"primary",textContent:"Cancel"});o.addEventListener("click",t??(()=>{})),i.replaceChildren(s,...e===null?[]:[r],...t?[o]:[])}function LP(n){fe.connected=!1,Xl(!1),ai.clutch=!1,Cd(ai),document.body.classList.add("lost"),fe.progress=null,yr(`${n} Nothing is felt or shown any more. ${fi?.stopped?"":"Trying again …"}`)}function NP(){fe.connected=!0,document.body.classList.remove("lost"),yr(null)}var Qr={get stage(){return nt},hand:ai,workspace:()=>fe.scene.workspace,grasp:()=>fe.snapshot?.grasp??[0,0,0],claims:n=>Xs!==null&&Xy(Xs,n),mayMove:()=>fe.connected&&!nt?.editing&&fe.hello?.may_control!==!1&&!!fe.state?.device.startsWith("web:")&&fe.state.holder!=="other"&&fe.state.run!=="ended"&&!fe.state.replay&&!!fe.snapshot,async press(){if(ai.clutch&&fe.holding||fe.asking)return;fe.asking=!0;let n=Td(ai);fe.holding||Xl((await Ws({type:"hold",value:!0})).ok),fe.asking=!1,fe.holding&&(dr(ai,performance.now()/1e3,n),ai.clutch=!0,kh())},moved:n=>{fe.turned||=n},give:DS,letGo:()=>{ai.clutch=!1,kh()}};function Xl(n){fe.holding&&!n&&px(fi),fe.holding=n}function DS(){if(!fe.holding||!fe.connected)return;let n=Cd(ai);dx(fi,n),fe.sent+=n.length}function kh(){!fe.holding||wS(aa)||(dr(ai,performance.now()/1e3),DS())}function Zp(){fe.holding&&(Qr.letGo(),Xl(!1),gr(fi,{type:"hold",value:!1}))}document.addEventListener("visibilitychange",()=>{document.hidden&&Zp()});addEventListener("pagehide",Zp);addEventListener("keydown",n=>{if(n.target.closest?.("input, select, textarea")||n.ctrlKey||n.metaKey||n.altKey)return;let i={" ":()=>ai.clutch?Qr.letGo():Qr.mayMove()&&Qr.press(),p:tn.pause,".":tn.step,r:tn.reset,f:tn.fit,o:tn.open,"?":tn.help,h:tn.help,l:()=>tn.view("wireframe"),g:()=>tn.view("ghost"),c:()=>tn.view("contacts"),a:()=>tn.view("forces"),n:()=>tn.view("names"),s:tn.sound,"+":()=>tn.zoom(.87),"-":()=>tn.zoom(1.15),...Object.fromEntries(Hp.map(([s,,r])=>[s,()=>tn.look(r)]))}[n.key.length===1?n.key.toLowerCase():""];!i||n.key===" "&&n.target.closest?.("button")||(n.preventDefault(),i())});function DP(){try{nt=J_(Gt("scene"),new URLSearchParams(location.search).get("picture"))}catch(n){return fe.trouble="This browser shows no WebGL 2, so there is no picture; numbers and plots work. Hardware acceleration may be off in its settings.",yr(fe.trouble),console.warn(String(n.message??n)),null}return nt.wants=(n,e)=>gr(fi,{type:"level",mesh:n,value:e}),uh(nt),Md(ca,nt.options),new ResizeObserver(()=>Al(nt)).observe(Gt("stage")),Al(nt),UP(),lx(Qr)}async function UP(){aa=bS({stage:nt,player:Qr,leave:Zp,moment:FS,changed:()=>yd(ca,aa.mode),take:()=>{fe.state?.devices.includes("web:")&&!fe.state.device.startsWith("web:")&&tn.device("web:")},strength:()=>Math.min(1,BS()/Jp())}),E0(ca,await MS(),n=>ES(aa,n).catch(({message:e})=>{fe.refusal={text:`The headset: ${e}`,until:performance.now()/1e3+6}}))}function TS(n,e){let t=Object.assign(document.createElement("a"),{href:URL.createObjectURL(e),download:n});t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}var CS=n=>`thigma-${(fe.snapshot?.time??0).toFixed(1)}s.${n}`,Wl=DP();wx(Gt("help"));var FP=()=>`${fe.scene?.title??""}, to ${(fe.snapshot?.time??0).toFixed(1)} s`,OP=_S(Gt("tabs"),[["plots","Plots"],["parameters","Parameters"],["levels","Levels"],["events","Events"],["build","Scene"]],n=>Ly(la,n==="build"));Ch(Oi);yr("Connecting …");var RS=/^#token=([0-9a-f]+)$/.exec(location.hash)?.[1];fi=fx(`${location.protocol==="https:"?"wss":"ws"}://${location.host}/live${RS?`?token=${RS}`:""}`,{message:n=>PP[n.type??n.kind]?.(n),opened:NP,lost:LP});setInterval(kh,bP);var qp=performance.now(),PS=0,US=0,IS=0;function FS(){fe.fresh&&(fe.shown=fe.snapshot,nt&&wl(nt,fe.shown),fe.fresh=!1)}function BP(){return aa?.session||nt&&!sx(nt)||(FS(),!nt||!rx(nt))?!1:(US+=1,dS(CP,nt,fe.shown),!0)}function OS(n){requestAnimationFrame(OS);let e=BS();Wl&&hx(Wl,(n-qp)/1e3,e,Jp()),Wl&&ux(Wl,(n-qp)/1e3),qp=n,kh();let t=BP();PS+=1,ay(Oi,fe.shown?.time??0);let i=performance.now();PS%6!==0&&!(t&&i>=IS)||(kP(n/1e3,e),IS=10*performance.now()-9*i)}var BS=()=>fe.snapshot?Math.hypot(...fe.snapshot.force):0;function Jp(){let n=fe.snapshot?.metresPerNewton;return n>0&&fe.scene?fe.scene.object.radius/n:3}function kP(n,e){A0(ca,fe),_y(EP,fe.shown,fe.state,fe.scene,fe.parameters,Oi.pointed),xy(Gt("row-legend"),fe.shown),vy(Gt("legend"),fe.shown,fe.scene,Zy(LS)),cS(NS,fe.state,fe.shown),T0(Gt("hint"),R0(wP,fe,{now:n,newtons:e,holding:fe.holding&&ai.clutch,turned:fe.turned,touch:Wl?.touch??matchMedia("(pointer: coarse)").matches},tn))}requestAnimationFrame(OS);window.thigma={session:fe,hand:ai,plots:Oi,sound:$p,player:Qr,act:tn,ask:n=>gr(fi,n),get stage(){return nt},get link(){return fi},get xr(){return aa},builder:la,get gizmo(){return Xs},get drawn(){return US}};})();
